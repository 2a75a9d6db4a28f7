// Signs of values, as far as they are known: that of a product follows from those of its factors.
//
// Method: equations over the field of two elements, one after the other. What two values share is a forest (union-find)
// in which every value knows its sign relative to its parent. An equation of more values makes one of them depend on
// the others; these were free when it was stated, so later equations say what they depend on, and in the order of the
// equations every value is replaced once. What is never undone goes into earlier equations, so that chains stay short.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace symreal::reroll {

class RelativeSigns {
public:
  explicit RelativeSigns(std::size_t count);

  // The sign of a product, as far as it is found with little work.
  struct Sign {
    std::vector<std::uint32_t> free = {}; // values that nothing is known of whose signs go into it: in order, each once
    bool negated = false;
    bool is_too_far = false; // it depends on more than is looked at

    bool is_known() const { return free.empty() && !is_too_far; }
    friend bool operator==(Sign const &, Sign const &) = default;
  };
  Sign of(std::initializer_list<std::uint32_t> factors);

  // From now on the product of these has this sign. False where that contradicts what is known, or is too far.
  bool relate(std::initializer_list<std::uint32_t> factors, bool is_negative);

  // A number of relations, to come back to: what later ones say is not known again.
  std::size_t mark() const { return related_.size(); }
  void undo_to(std::size_t mark);
  // Nobody comes back to a mark before this.
  void keep() { kept_ = related_.size(); }

  // Per value whether it is a negative, where those are none that nothing is known of.
  std::vector<char> negatives() const;

private:
  static constexpr std::uint32_t free_value = ~std::uint32_t{0};

  // The value's root, and whether its sign is the opposite one; by relations before `end`.
  std::pair<std::uint32_t, bool> root(std::uint32_t value, std::size_t end = free_value) const;
  bool depends_for_good(std::uint32_t value) const { return relation_[root(value).first] < kept_; }
  bool is_short(std::uint32_t relation) const;
  void shorten(std::uint32_t relation);
  void shorten_by_short_ones(Sign &sign) const;

  std::vector<std::uint32_t> parent_, size_;
  std::vector<char> is_opposite_;       // to the parent
  std::vector<std::uint32_t> relation_; // per value: what gave it a parent or made it depend on others; or it is free
  // Per relation the value that is no longer free, and on what it depends: on nothing if it has a parent.
  std::vector<std::uint32_t> related_;
  std::vector<Sign> depends_;
  std::size_t kept_ = 0; // relations
};

} // namespace symreal::reroll
