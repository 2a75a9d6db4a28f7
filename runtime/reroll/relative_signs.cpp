#include "reroll/relative_signs.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace symreal::reroll {

RelativeSigns::RelativeSigns(std::size_t count)
    : parent_(count),
      size_(count, 1),
      is_opposite_(count, 0),
      equation_(count, free_value) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

std::pair<std::uint32_t, bool> RelativeSigns::root(std::uint32_t value) const {
  bool negated = false;
  for (; parent_[value] != value; value = parent_[value]) negated = negated != (is_opposite_[value] != 0);
  return {value, negated};
}

// A product of products of many iterations depends on all of them: that many signs are seldom worth their time.
static constexpr std::size_t most_free = 8, most_equations = 1024;

RelativeSigns::Sign RelativeSigns::of(std::initializer_list<std::uint32_t> factors) const {
  Sign sign;
  using Pending = std::pair<std::uint32_t, std::uint32_t>; // the equation of a root, and the root
  std::priority_queue<Pending, std::vector<Pending>, std::greater<>> pending;
  auto const add = [&](std::uint32_t factor) {
    auto const [value, negated] = root(factor);
    sign.negated = sign.negated != negated;
    pending.push({equation_[value], value});
  };
  for (std::uint32_t const factor : factors) add(factor);
  for (std::size_t equations = 0; !pending.empty();) {
    auto const [equation, value] = pending.top();
    pending.pop();
    if (!pending.empty() && pending.top().second == value) {
      pending.pop(); // a square
    } else if (equation == free_value) {
      sign.free.push_back(value);
      if (sign.free.size() > most_free) return {.is_too_far = true};
    } else {
      if (++equations > most_equations) return {.is_too_far = true};
      sign.negated = sign.negated != depends_[equation].negated;
      for (std::uint32_t const other : depends_[equation].free) add(other);
    }
  }
  return sign;
}

bool RelativeSigns::relate(std::initializer_list<std::uint32_t> factors, bool is_negative) {
  Sign sign = of(factors);
  sign.negated = sign.negated != is_negative;
  if (sign.is_too_far) return false;
  if (sign.is_known()) return !sign.negated;
  auto const chosen = std::ranges::min_element(sign.free, {}, [&](std::uint32_t value) { return size_[value]; });
  std::uint32_t const value = *chosen;
  sign.free.erase(chosen);
  related_.push_back(value);
  if (sign.free.size() == 1) {
    parent_[value] = sign.free.front();
    size_[parent_[value]] += size_[value];
    is_opposite_[value] = sign.negated;
    depends_.emplace_back();
  } else {
    equation_[value] = static_cast<std::uint32_t>(depends_.size());
    depends_.push_back(std::move(sign));
  }
  return true;
}

void RelativeSigns::undo_to(std::size_t mark) {
  for (; related_.size() > mark; related_.pop_back(), depends_.pop_back()) {
    std::uint32_t const value = related_.back();
    if (parent_[value] != value) size_[parent_[value]] -= size_[value];
    parent_[value] = value;
    is_opposite_[value] = 0;
    equation_[value] = free_value;
  }
}

std::vector<char> RelativeSigns::negatives() const {
  std::vector<char> negative(parent_.size(), 0);
  auto const of_value = [&](std::uint32_t value) {
    auto const [from, negated] = root(value);
    return (negative[from] != 0) != negated;
  };
  for (std::size_t k = related_.size(); k-- > 0;) { // what they depend on was related later
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
