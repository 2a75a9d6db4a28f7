// The variables of a functional mock-up unit: the numbers of a graph, each with what FMI says of it.
#pragma once

#include "engine/graph/graph.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct UnitVariable {
  enum class Role { time, input, state, parameter, output, derivative };
  std::string name;
  Role role = Role::time;
  double start = 0;                      // of what is set from outside
  std::size_t state = 0;                 // of a derivative: the state's index
  std::vector<std::size_t> dependencies; // of what is computed: inputs, states and parameters by their indices
};

// Index 0 is time; then come inputs, parameters and outputs in their order. An index is a value reference.
std::vector<UnitVariable> unit_variables(Graph const &graph);

} // namespace symreal::tool
