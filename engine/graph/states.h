// Which inputs of a graph are states, and which outputs are their derivatives by time.
#pragma once

#include "engine/graph/graph.h"

#include <vector>

namespace symreal {

// Indices of an input and an output.
struct State {
  std::size_t input, output;
};

// In the order of the inputs. Throws pragma_syntax where a pair names no objects, objects of different shapes, or one
// that another pair names.
std::vector<State> find_states(Graph const &graph);

} // namespace symreal
