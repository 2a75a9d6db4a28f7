// State variables of a graph, paired with the outputs that are their time derivatives.
#pragma once

#include "engine/graph/graph.h"

#include <vector>

namespace symreal {

// Indices of an input and an output.
struct State {
  std::size_t input, output;
};

// States in input order. Throws pragma_syntax if a pair names unknown objects, objects of different shapes, or one that
// another pair names.
std::vector<State> find_states(Graph const &graph);

} // namespace symreal
