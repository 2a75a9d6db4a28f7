// Operations that may be computed side by side: those of one shape.
#pragma once

#include "engine/plan/lanes/function.h"

namespace symreal::lanes {

enum class Depth { whole, few };

// Groups of at least `width` of these nodes whose whole expressions, or a few operations of them, are the same: in the
// order of nodes, and, if that is another, in the order of the elements that they read.
std::vector<std::vector<std::vector<NodeId>>> alike(Function const &function, std::vector<NodeId> const &nodes,
                                                    Depth depth);

} // namespace symreal::lanes
