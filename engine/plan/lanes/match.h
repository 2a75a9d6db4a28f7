// Which operands of isomorphic operations belong together.
#pragma once

#include "engine/plan/lanes/function.h"

#include <optional>

namespace symreal::lanes {

// Operations of several nodes as one of vectors.
struct Match {
  Op op;
  std::vector<char> subtracts = {};           // as that of a vector
  std::array<std::vector<NodeId>, 2> operand; // the second is empty where there is none
};

// Nothing where the operations differ, or are no operations of vectors, or all are the same node.
std::optional<Match> match(Function const &function, std::vector<NodeId> const &nodes);

} // namespace symreal::lanes
