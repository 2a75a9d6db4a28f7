#include "engine/plan/reroll/relative_signs.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace symreal::reroll {

// Work limits: a product chained over many iterations depends on a sign of each, which is seldom worth the time.
static constexpr std::size_t most_free = 8, most_relations = 1024;

RelativeSigns::RelativeSigns(std::size_t count)
    : parent_(count),
      size_(count, 1),
      is_opposite_(count, 0),
      relation_(count, free_value) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

std::pair<std::uint32_t, bool> RelativeSigns::root(std::uint32_t value, std::size_t end) const {
  bool negated = false;
  for (; parent_[value] != value && relation_[value] < end; value = parent_[value])
    negated = negated != (is_opposite_[value] != 0);
  return {value, negated};
}

RelativeSigns::Sign RelativeSigns::of(std::initializer_list<std::uint32_t> factors) {
  Sign sign;
  using Pending = std::pair<std::uint32_t, std::uint32_t>; // relation that determines a root, and the root
  std::priority_queue<Pending, std::vector<Pending>, std::greater<>> pending;
  auto const add = [&](std::uint32_t factor) {
    auto const [value, negated] = root(factor);
    sign.negated = sign.negated != negated;
    pending.push({relation_[value], value});
  };
  for (std::uint32_t const factor : factors) add(factor);
  for (std::size_t relations = 0; !pending.empty();) {
    auto const [relation, value] = pending.top();
    pending.pop();
    if (!pending.empty() && pending.top().second == value) {
      pending.pop(); // a square
    } else if (relation == free_value) {
      sign.free.push_back(value);
      if (sign.free.size() > most_free) return {.is_too_far = true};
    } else {
      shorten(relation);
      if (++relations > most_relations || depends_[relation].is_too_far) return {.is_too_far = true};
      sign.negated = sign.negated != depends_[relation].negated;
      for (std::uint32_t const other : depends_[relation].free) add(other);
    }
  }
  return sign;
}

bool RelativeSigns::is_short(std::uint32_t relation) const {
  Sign const &sign = depends_[relation];
  return sign.is_too_far ||
         std::ranges::none_of(sign.free, [&](std::uint32_t value) { return depends_for_good(value); });
}

// Substitutes permanently dependent values by free ones. The relations that it depends on, which are later ones, are
// shortened first; iterative, since chains may be long.
void RelativeSigns::shorten(std::uint32_t relation) {
  std::vector<std::uint32_t> pending = {relation};
  while (!pending.empty()) {
    std::uint32_t const last = pending.back();
    if (is_short(last)) {
      pending.pop_back();
      continue;
    }
    std::size_t const before = pending.size();
    for (std::uint32_t const value : depends_[last].free)
      if (std::uint32_t const other = relation_[root(value).first]; other < kept_ && !is_short(other))
        pending.push_back(other);
    if (pending.size() == before) shorten_by_short_ones(depends_[last]);
  }
}

void RelativeSigns::shorten_by_short_ones(Sign &sign) const {
  Sign result{.negated = sign.negated};
  for (std::uint32_t const value : sign.free) {
    auto const [from, negated] = root(value, kept_);
    result.negated = result.negated != negated;
    if (relation_[from] >= kept_) {
      result.free.push_back(from);
      continue;
    }
    Sign const &other = depends_[relation_[from]];
    result.is_too_far = result.is_too_far || other.is_too_far;
    result.negated = result.negated != other.negated;
    result.free.insert(result.free.end(), other.free.begin(), other.free.end());
  }
  std::ranges::sort(result.free);
  std::vector<std::uint32_t> once; // without squares
  for (std::uint32_t const value : result.free)
    if (!once.empty() && once.back() == value)
      once.pop_back();
    else
      once.push_back(value);
  if (result.is_too_far || once.size() > most_free) {
    sign.is_too_far = true; // the sign keeps its old form
    return;
  }
  result.free = std::move(once);
  sign = std::move(result);
}

bool RelativeSigns::relate(std::initializer_list<std::uint32_t> factors, bool is_negative) {
  Sign sign = of(factors);
  sign.negated = sign.negated != is_negative;
  if (sign.is_too_far) return false;
  if (sign.is_known()) return !sign.negated;
  auto const chosen = std::ranges::min_element(sign.free, {}, [&](std::uint32_t value) { return size_[value]; });
  std::uint32_t const value = *chosen;
  sign.free.erase(chosen);
  relation_[value] = static_cast<std::uint32_t>(related_.size());
  related_.push_back(value);
  if (sign.free.size() == 1) {
    parent_[value] = sign.free.front();
    size_[parent_[value]] += size_[value];
    is_opposite_[value] = sign.negated;
    depends_.emplace_back();
  } else {
    depends_.push_back(std::move(sign));
  }
  return true;
}

void RelativeSigns::undo_to(std::size_t mark) {
  internal_check(mark >= kept_);
  for (; related_.size() > mark; related_.pop_back(), depends_.pop_back()) {
    std::uint32_t const value = related_.back();
    if (parent_[value] != value) size_[parent_[value]] -= size_[value];
    parent_[value] = value;
    is_opposite_[value] = 0;
    relation_[value] = free_value;
  }
}

std::vector<char> RelativeSigns::negatives() const {
  std::vector<char> negative(parent_.size(), 0);
  auto const of_value = [&](std::uint32_t value) {
    auto const [from, negated] = root(value);
    return (negative[from] != 0) != negated;
  };
  for (std::size_t k = related_.size(); k-- > 0;) { // dependencies are on later relations
    if (parent_[related_[k]] != related_[k]) continue;
    bool negated = depends_[k].negated;
    for (std::uint32_t const other : depends_[k].free) negated = negated != of_value(other);
    negative[related_[k]] = negated;
  }
  for (std::uint32_t value = 0; value < parent_.size(); ++value)
    if (parent_[value] != value) negative[value] = of_value(value);
  return negative;
}

} // namespace symreal::reroll
