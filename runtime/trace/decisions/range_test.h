// Conditions that the bounds of the numbers in them settle: `fabs(x) < -1` by the operations, `x > 4` by the range of
// the input x.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"

#include <optional>

namespace symreal::trace {

// Outcomes implied by the operations alone, and also by the ranges of these inputs.
std::optional<bool> outcome_of_bounds(NodeTable const &nodes, NodeId condition);
std::optional<bool> outcome_in_ranges(NodeTable const &nodes, NodeId condition, std::vector<Object> const &inputs);

} // namespace symreal::trace
