// Tests of a computed number for exact zero, as in `pivot != 0` and `norm <= DBL_MIN`.
#pragma once

#include "engine/graph/node_table.h"

#include <optional>

namespace symreal::trace {

// The outcome of the condition if the number is not 0; nullopt if the condition is not a zero test. Plain inputs and
// parameters do not count: a mode that is 0 may well be meant.
std::optional<bool> outcome_without_zero(NodeTable const &nodes, NodeId condition);

} // namespace symreal::trace
