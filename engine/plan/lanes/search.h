// Search for operations to pack into vectors.
#pragma once

#include "engine/plan/lanes/needs.h"

namespace symreal::lanes {

// Vectors start at contiguous results and at operations of one shape, and grow along their operands. Vectors that
// reduce the function's cost are kept.
struct Found {
  Packs packs;
  std::vector<Store> stores;
};

Found search(Function const &function);

} // namespace symreal::lanes
