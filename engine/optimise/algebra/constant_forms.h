// How the numbers of a program come from one another.
//
// The program rounded what it computed from constants alone before anything was recorded: where it multiplied a mass by
// an offset, the graph has one number. Algebra that does not see the product does not see that the two halves of a
// matrix are equal, nor that what should be 0 is. So a number that is, to the last bit, the rounded sum, product or
// quotient of others, or a product added to a number, is taken for what it is the rounding of. That this is so by
// chance has probability 2^-52 for each pair of numbers.
#pragma once

#include "engine/optimise/algebra/key_table.h"

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace symreal::algebra {

enum class FormKind : std::uint8_t { sum, product, quotient, sum_with_product };

// a + b, a * b, a / b, or a + b * c, or the negative of that.
struct ConstantForm {
  FormKind kind;
  double a, b, c = 0;
};

class ConstantForms {
public:
  // Magnitudes, in the order in which they occur; of thousands, those far apart are not compared. Of several forms
  // that fit, one of earlier numbers is taken: a quotient is known by its dividend, not the other way round.
  explicit ConstantForms(std::span<double const> constants);

  // Null for a number that is none of these. Forms of forms come to an end.
  ConstantForm const *find(double magnitude) const;

private:
  struct Product {
    double value, a, b;
  };
  static constexpr int deepest = 4;

  void look_at_pairs();
  void look_at_products();
  void propose(double value, ConstantForm const &form);
  bool rests_on(double constant, double other, int depth) const;
  // Among the constants; KeyTable::none for a magnitude that is not one of them.
  std::uint32_t place_of(double magnitude) const { return place_.find(std::bit_cast<std::uint64_t>(magnitude)); }

  std::vector<double> constants_;
  std::vector<std::optional<ConstantForm>> forms_; // of each
  KeyTable place_;
  bool only_earlier_ = true;
};

} // namespace symreal::algebra
