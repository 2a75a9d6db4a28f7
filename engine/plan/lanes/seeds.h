// Seeds of vectors: groups of operations of one shape.
#pragma once

#include "engine/plan/lanes/function.h"

namespace symreal::lanes {

enum class Depth { whole, few };

// Groups of at least `width` of these nodes with the same expression, whole or a few operations deep: in the order of
// nodes and, if it differs, in the order of the elements that they read.
std::vector<std::vector<std::vector<NodeId>>> alike(Function const &function, std::vector<NodeId> const &nodes,
                                                    Depth depth);

} // namespace symreal::lanes
