// How the numbers of a program come from one another.
//
// The program rounded what it computed from constants alone before anything was recorded: where it multiplied a mass by
// an offset, the graph has one number. Algebra that does not see the product does not see that the two halves of a
// matrix are equal. So a number that is, to the last bit, the rounded product, sum, difference or inverse of others is
// taken for what it is the rounding of. By chance that is so with probability 2^-52 for each pair of numbers.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace symreal::algebra {

enum class FormKind : std::uint8_t { product, sum, difference, inverse };

struct ConstantForm {
  FormKind kind;
  double a, b;
};

class ConstantForms {
public:
  // Magnitudes, in the order in which they occur; far apart from one another they are not compared.
  explicit ConstantForms(std::span<double const> constants);

  // Null for a number that is none of these. Forms of forms come to an end.
  ConstantForm const *find(double magnitude) const;

private:
  static constexpr std::size_t farthest = 600;
  static constexpr int deepest = 4;

  void look(double a, double b);
  void propose(FormKind kind, double a, double b, double value);
  bool rests_on(double constant, double other, int depth) const;

  std::unordered_map<double, bool> known_;
  std::unordered_map<double, ConstantForm> forms_;
};

} // namespace symreal::algebra
