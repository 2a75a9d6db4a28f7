// Products that several windows read, computed in each of them.
//
// Each term of a series multiplies the same variable by a constant. Where two terms have the same constant, only the
// first computes the product, and then neither is like the terms around it. Computed again, all terms are alike.
#pragma once

#include "engine/plan/reroll/sequence.h"

#include <memory>
#include <optional>

namespace symreal::reroll {

struct OwnProducts {
  std::unique_ptr<Graph> graph; // with further nodes at its end, which operations before them may read
  Sequence sequence;            // of this graph
};

// None: there are too few to matter.
std::optional<OwnProducts> with_own_products(Sequence const &sequence);

} // namespace symreal::reroll
