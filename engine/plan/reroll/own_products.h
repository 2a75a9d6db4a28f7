// Duplication of products that several windows share.
//
// Each term of a series multiplies the same variable by a constant. If two terms have the same constant, only the first
// computes the product, and neither resembles the terms around it. With the product computed in both, all terms match.
#pragma once

#include "engine/plan/reroll/sequence.h"

#include <memory>
#include <optional>

namespace symreal::reroll {

struct OwnProducts {
  std::unique_ptr<Graph> graph; // has extra nodes at its end, which earlier operations may read
  Sequence sequence;            // of `graph`
};

// Sequence with the duplicated products; nullopt if there are too few of them.
std::optional<OwnProducts> with_own_products(Sequence const &sequence);

} // namespace symreal::reroll
