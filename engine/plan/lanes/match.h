// Pairing of the operands of isomorphic operations.
#pragma once

#include "engine/plan/lanes/function.h"

#include <optional>

namespace symreal::lanes {

// Operations on several nodes as one vector operation.
struct Match {
  Op op;
  std::vector<char> subtracts = {};           // as in Vector
  std::array<std::vector<NodeId>, 2> operand; // the second is empty for unary operations
};

// Matched operations; nullopt if they differ, have no vector form, or are all the same node.
std::optional<Match> match(Function const &function, std::vector<NodeId> const &nodes);

} // namespace symreal::lanes
