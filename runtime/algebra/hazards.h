// What an expression must not come to depend on.
//
// A quotient, and a function that is not defined everywhere, may be computed only where the program computes it: behind
// a guard, or in the arm that a select takes. So an expression may be put in place of another only if it rests on no
// such operation that the other does not rest on. Each expression has the set of those operations; equal sets have
// equal numbers.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace symreal::algebra {

using HazardSet = std::uint32_t;
inline constexpr HazardSet no_hazard = 0;

class HazardSets {
public:
  HazardSets() : sets_(1) {}

  // The set of one operation, told from others by `key`.
  HazardSet of(std::uint64_t key);
  HazardSet unite(HazardSet a, HazardSet b);
  // Never yes where it is no. The union of very large sets is a subset of itself alone.
  bool is_subset(HazardSet a, HazardSet b) const;

private:
  static constexpr std::size_t largest = 128;

  HazardSet number_of(std::vector<std::uint32_t> elements);

  std::vector<std::vector<std::uint32_t>> sets_; // sorted; empty, but for the first, of what is too large
  std::unordered_map<std::uint64_t, std::uint32_t> elements_;
  std::unordered_multimap<std::uint64_t, HazardSet> numbers_; // by a hash of the elements
  std::unordered_map<std::uint64_t, HazardSet> unions_;
};

} // namespace symreal::algebra
