// Chains of operations with equal ends: the candidates for loop interchange (interchange.h).
#pragma once

#include "engine/plan/reroll/repeats.h"

#include <algorithm>

namespace symreal::reroll {

// Ends of chains, and per pair of neighbours the number of operations that their ends have in common.
struct Chains {
  std::vector<std::uint32_t> ends, common;

  std::size_t size() const { return ends.size(); }
  std::uint32_t length(std::size_t chain) const {
    return std::max(chain == 0 ? 0 : common[chain - 1], chain < common.size() ? common[chain] : 0);
  }
  std::uint32_t begin(std::size_t chain) const { return ends[chain] - length(chain); }
};

// Chains that are independent of each other and of the operations between them, with strictly increasing or strictly
// decreasing lengths; in order of their ends. Takes the time of sorting the sequence.
std::vector<Chains> find_chains(Sequence const &sequence);

} // namespace symreal::reroll
