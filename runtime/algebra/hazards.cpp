#include "algebra/hazards.h"

#include "algebra/prime_field.h"

#include <algorithm>
#include <iterator>

namespace symreal::algebra {

HazardSet HazardSets::of(std::uint64_t key) {
  auto const [element, is_new] = elements_.emplace(key, static_cast<std::uint32_t>(elements_.size()));
  return number_of({element->second});
}

HazardSet HazardSets::number_of(std::vector<std::uint32_t> elements) {
  std::uint64_t hash = elements.size();
  for (std::uint32_t element : elements) hash = mixed(hash + element);
  auto const [first, last] = numbers_.equal_range(hash);
  for (auto known = first; known != last; ++known)
    if (sets_[known->second] == elements) return known->second;
  auto const number = static_cast<HazardSet>(sets_.size());
  sets_.push_back(std::move(elements));
  numbers_.emplace(hash, number);
  return number;
}

HazardSet HazardSets::unite(HazardSet a, HazardSet b) {
  if (a == b || b == no_hazard) return a;
  if (a == no_hazard) return b;
  if (a > b) std::swap(a, b);
  auto const [known, is_new] = unions_.emplace(std::uint64_t{a} << 32 | b, no_hazard);
  if (!is_new) return known->second;
  std::vector<std::uint32_t> united;
  std::ranges::set_union(sets_[a], sets_[b], std::back_inserter(united));
  if (sets_[a].empty() || sets_[b].empty() || united.size() > largest) {
    sets_.emplace_back();
    return known->second = static_cast<HazardSet>(sets_.size() - 1);
  }
  return known->second = number_of(std::move(united));
}

bool HazardSets::is_subset(HazardSet a, HazardSet b) const {
  if (a == b || a == no_hazard) return true;
  if (sets_[a].empty()) return false;
  return std::ranges::includes(sets_[b], sets_[a]);
}

} // namespace symreal::algebra
