// Chains of operations that end alike: which loop interchange (interchange.h) makes loops of.
#pragma once

#include "engine/plan/reroll/repeats.h"

#include <algorithm>

namespace symreal::reroll {

// Where chains end, and per neighbours how many operations they have in common at their ends.
struct Chains {
  std::vector<std::uint32_t> ends, common;

  std::size_t size() const { return ends.size(); }
  std::uint32_t length(std::size_t chain) const {
    return std::max(chain == 0 ? 0 : common[chain - 1], chain < common.size() ? common[chain] : 0);
  }
  std::uint32_t begin(std::size_t chain) const { return ends[chain] - length(chain); }
};

// Of which none waits for another one, nothing between them waits for them, and each has more operations than the one
// before, or each has fewer. By where they end. Time is that of sorting the sequence.
std::vector<Chains> find_chains(Sequence const &sequence);

} // namespace symreal::reroll
