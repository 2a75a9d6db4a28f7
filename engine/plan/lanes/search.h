// Which operations are computed side by side.
#pragma once

#include "engine/plan/lanes/needs.h"

namespace symreal::lanes {

// Vectors begin at results that stand side by side and at operations of one shape, and grow along their operands. What
// makes the function cheaper stays.
struct Found {
  Packs packs;
  std::vector<Store> stores;
};

Found search(Function const &function);

} // namespace symreal::lanes
