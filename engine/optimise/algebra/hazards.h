// What an expression must not come to rest on.
//
// A quotient, and a function that is not defined everywhere, may be computed only where the program computes it: behind
// a guard, or in the arm that a select takes. And what does not depend on an input must not become the difference of
// two values that do, which is lost in their rounding where that input is large. So an expression may be put in place
// of another only if it rests on no such operation and no input that the other does not rest on. Each expression has
// the set of those; equal sets have equal numbers.
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

  // The set of one operation, told from others by `key`; of one input.
  HazardSet of_operation(std::uint64_t key) { return number_of(single(element_of(key))); }
  HazardSet of_input(std::uint32_t slot);
  HazardSet inputs_in(HazardSet set);
  HazardSet unite(HazardSet a, HazardSet b);
  // Never yes where it is no. The union of very large sets is a subset of itself alone.
  bool is_subset(HazardSet a, HazardSet b) const;

private:
  using Bits = std::vector<std::uint64_t>; // without zeros at the end
  static constexpr std::size_t most_words = 128;

  std::uint32_t element_of(std::uint64_t key);
  static Bits single(std::uint32_t element);
  HazardSet number_of(Bits bits);
  HazardSet too_large();

  std::vector<Bits> sets_; // empty, but for the first, of what is too large
  Bits inputs_;
  std::unordered_map<std::uint64_t, std::uint32_t> elements_;
  std::unordered_multimap<std::uint64_t, HazardSet> numbers_; // by a hash of the bits
  std::unordered_map<std::uint64_t, HazardSet> unions_;
};

} // namespace symreal::algebra
