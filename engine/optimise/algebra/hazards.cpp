#include "engine/optimise/algebra/hazards.h"

#include "engine/optimise/algebra/prime_field.h"

#include <algorithm>
#include <utility>

namespace symreal::algebra {

std::uint32_t HazardSets::element_of(std::uint64_t key) {
  return elements_.emplace(key, static_cast<std::uint32_t>(elements_.size())).first->second;
}

HazardSets::Bits HazardSets::single(std::uint32_t element) {
  Bits bits(element / 64 + 1, 0);
  bits.back() = std::uint64_t{1} << element % 64;
  return bits;
}

HazardSet HazardSets::of_input(std::uint32_t slot) {
  std::uint32_t const element = element_of(std::uint64_t{1} << 63 | slot);
  inputs_.resize(std::max<std::size_t>(inputs_.size(), element / 64 + 1), 0);
  inputs_[element / 64] |= std::uint64_t{1} << element % 64;
  return number_of(single(element));
}

HazardSet HazardSets::inputs_in(HazardSet set) {
  if (set != no_hazard && sets_[set].empty()) return too_large();
  Bits bits = sets_[set];
  bits.resize(std::min(bits.size(), inputs_.size()));
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] &= inputs_[i];
  while (!bits.empty() && bits.back() == 0) bits.pop_back();
  return bits.empty() ? no_hazard : number_of(std::move(bits));
}

HazardSet HazardSets::too_large() {
  sets_.emplace_back();
  return static_cast<HazardSet>(sets_.size() - 1);
}

HazardSet HazardSets::number_of(Bits bits) {
  if (bits.size() > most_words) return too_large();
  std::uint64_t hash = bits.size();
  for (std::uint64_t word : bits) hash = mixed(hash + word);
  auto const [first, last] = numbers_.equal_range(hash);
  for (auto known = first; known != last; ++known)
    if (sets_[known->second] == bits) return known->second;
  auto const number = static_cast<HazardSet>(sets_.size());
  sets_.push_back(std::move(bits));
  numbers_.emplace(hash, number);
  return number;
}

HazardSet HazardSets::unite(HazardSet a, HazardSet b) {
  if (a == b || b == no_hazard) return a;
  if (a == no_hazard) return b;
  if (a > b) std::swap(a, b);
  auto const [known, is_new] = unions_.emplace(std::uint64_t{a} << 32 | b, no_hazard);
  if (!is_new) return known->second;
  if (sets_[a].empty() || sets_[b].empty()) return known->second = too_large();
  Bits united = sets_[a];
  united.resize(std::max(sets_[a].size(), sets_[b].size()), 0);
  for (std::size_t i = 0; i < sets_[b].size(); ++i) united[i] |= sets_[b][i];
  return known->second = number_of(std::move(united));
}

bool HazardSets::is_subset(HazardSet a, HazardSet b) const {
  if (a == b || a == no_hazard) return true;
  Bits const &small = sets_[a], &large = sets_[b];
  if (small.empty() || small.size() > large.size()) return false;
  for (std::size_t i = 0; i < small.size(); ++i)
    if ((small[i] & ~large[i]) != 0) return false;
  return true;
}

} // namespace symreal::algebra
