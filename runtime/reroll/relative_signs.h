// Signs of values, as far as they are known: each is that of another value, or the opposite one.
//
// A forest of values (union-find) in which every value knows its sign relative to its parent.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace symreal::reroll {

// What is computed in place of a value: itself, or its negative.
struct SignedValue {
  std::uint32_t value;
  bool negated = false;
};

class RelativeSigns {
public:
  explicit RelativeSigns(std::size_t count) : parent_(count), size_(count, 1), is_opposite_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  // The value's root, and whether the sign is the opposite one.
  SignedValue root(std::uint32_t value) const {
    bool negated = false;
    for (; parent_[value] != value; value = parent_[value]) negated = negated != (is_opposite_[value] != 0);
    return {value, negated};
  }

  // From now on the two are both themselves or both negatives; where `are_opposite`, one of each. False where that
  // contradicts what is known.
  bool relate(std::uint32_t a, std::uint32_t b, bool are_opposite) {
    SignedValue x = root(a), y = root(b);
    bool const opposite = (x.negated != y.negated) != are_opposite;
    if (x.value == y.value) return !opposite;
    if (size_[x.value] > size_[y.value]) std::swap(x, y);
    parent_[x.value] = y.value;
    size_[y.value] += size_[x.value];
    is_opposite_[x.value] = opposite;
    related_.push_back(x.value);
    return true;
  }

  // A number of relations, to come back to: the roots of later ones are roots again.
  std::size_t mark() const { return related_.size(); }
  void undo_to(std::size_t mark) {
    for (; related_.size() > mark; related_.pop_back()) {
      std::uint32_t const value = related_.back();
      size_[parent_[value]] -= size_[value];
      parent_[value] = value;
      is_opposite_[value] = 0;
    }
  }

private:
  std::vector<std::uint32_t> parent_, size_;
  std::vector<char> is_opposite_; // to its parent
  std::vector<std::uint32_t> related_;
};

} // namespace symreal::reroll
