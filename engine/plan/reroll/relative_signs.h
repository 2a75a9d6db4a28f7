// Relative signs of values: a solver of equations that give the sign of a product.
//
// Method: linear equations over GF(2), solved incrementally. Equations of two values form a union-find forest in which
// every value has its sign relative to its parent. An equation of more values makes one of them depend on the others,
// which were free when it was stated; so substituting in the order of the equations replaces each value once. Permanent
// equations are substituted into earlier ones, so that chains stay short.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace symreal::reroll {

class RelativeSigns {
public:
  explicit RelativeSigns(std::size_t count);

  // Sign of a product, as far as it is found within the work limit.
  struct Sign {
    std::vector<std::uint32_t> free = {}; // undetermined values whose signs are factors: ascending, each once
    bool negated = false;
    bool is_too_far = false; // the work limit was exceeded

    bool is_known() const { return free.empty() && !is_too_far; }
    friend bool operator==(Sign const &, Sign const &) = default;
  };
  Sign of(std::initializer_list<std::uint32_t> factors);

  // States the sign of a product. False if that contradicts earlier relations or exceeds the work limit.
  bool relate(std::initializer_list<std::uint32_t> factors, bool is_negative);

  // Mark for undo_to, which drops all later relations.
  std::size_t mark() const { return related_.size(); }
  void undo_to(std::size_t mark);
  // Makes the relations so far permanent: marks before this are no longer used.
  void keep() { kept_ = related_.size(); }

  // Per value whether it is negative; undetermined values count as positive.
  std::vector<char> negatives() const;

private:
  static constexpr std::uint32_t free_value = ~std::uint32_t{0};

  // Root of the value, and whether its sign is opposite to the root's; uses relations before `end`.
  std::pair<std::uint32_t, bool> root(std::uint32_t value, std::size_t end = free_value) const;
  bool depends_for_good(std::uint32_t value) const { return relation_[root(value).first] < kept_; }
  bool is_short(std::uint32_t relation) const;
  void shorten(std::uint32_t relation);
  void shorten_by_short_ones(Sign &sign) const;

  std::vector<std::uint32_t> parent_, size_;
  std::vector<char> is_opposite_;       // relative to the parent
  std::vector<std::uint32_t> relation_; // per value: relation that gave it a parent or made it dependent, or free_value
  // Per relation the value that it determines, and that value's factors (empty if it has a parent).
  std::vector<std::uint32_t> related_;
  std::vector<Sign> depends_;
  std::size_t kept_ = 0; // number of permanent relations
};

} // namespace symreal::reroll
