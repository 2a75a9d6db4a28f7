// Hazards: operations and inputs that a replacement must not newly depend on.
//
// A quotient, or a function that is not defined everywhere, may be computed only where the program computes it: behind
// a guard, or in the arm that a select takes. And a value that does not depend on an input must not become the
// difference of two values that do, since rounding destroys it if that input is large. So an expression may replace
// another only if its hazards, such operations and inputs, are a subset of the other's. Equal sets have equal numbers.
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

  // Singleton sets: of an operation, identified by `key`, and of an input.
  HazardSet of_operation(std::uint64_t key) { return number_of(single(element_of(key))); }
  HazardSet of_input(std::uint32_t slot);
  HazardSet inputs_in(HazardSet set);
  HazardSet unite(HazardSet a, HazardSet b);
  // Conservative: true only if `a` is a subset of `b`. A very large union is a subset of itself alone.
  bool is_subset(HazardSet a, HazardSet b) const;

private:
  using Bits = std::vector<std::uint64_t>; // without trailing zeros
  static constexpr std::size_t most_words = 128;

  std::uint32_t element_of(std::uint64_t key);
  static Bits single(std::uint32_t element);
  HazardSet number_of(Bits bits);
  HazardSet too_large();

  std::vector<Bits> sets_; // all but the first: empty if too large
  Bits inputs_;
  std::unordered_map<std::uint64_t, std::uint32_t> elements_;
  std::unordered_multimap<std::uint64_t, HazardSet> numbers_; // keyed by a hash of the bits
  std::unordered_map<std::uint64_t, HazardSet> unions_;
};

} // namespace symreal::algebra
