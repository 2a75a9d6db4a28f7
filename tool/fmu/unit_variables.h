// Variables of a functional mock-up unit: the numbers of a graph with their FMI attributes.
#pragma once

#include "engine/graph/graph.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct UnitVariable {
  enum class Role { time, input, state, parameter, output, derivative };
  std::string name;
  Role role = Role::time;
  double start = 0;                      // start value of variables set from outside
  std::size_t state = 0;                 // of a derivative: index of its state
  std::vector<std::size_t> dependencies; // of computed variables: indices of inputs, states and parameters
};

// All variables: index 0 is time, then inputs, parameters and outputs in order. The index is the value reference.
std::vector<UnitVariable> unit_variables(Graph const &graph);

} // namespace symreal::tool
