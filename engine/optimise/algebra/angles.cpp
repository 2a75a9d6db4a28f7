#include "engine/optimise/algebra/angles.h"

#include <cstdlib>

namespace symreal::algebra {

namespace {

struct Rotation {
  Residue sine = 0, cosine = 1;

  Rotation operator*(Rotation const &b) const {
    return {add(multiply(sine, b.cosine), multiply(cosine, b.sine)),
            subtract(multiply(cosine, b.cosine), multiply(sine, b.sine))};
  }
  Rotation operator-() const { return {negate(sine), cosine}; }
};

Rotation power(Rotation base, int exponent) {
  if (exponent < 0) base = -base;
  Rotation result;
  for (int k = 0; k < std::abs(exponent); ++k) result = result * base;
  return result;
}

} // namespace

Angles::Point const *Angles::find(Value const &angle) const {
  auto const found = points_.find(angle.key());
  if (found == points_.end()) return nullptr;
  bool const is_it = found->second.angle == angle.field || found->second.angle == (-angle).field;
  return is_it ? &found->second : nullptr;
}

Value Angles::sine(Value const &angle) const {
  Value result = algebra::sine(angle);
  if (Point const *point = find(angle))
    for (std::size_t k = 0; k < field_points; ++k)
      result.field[k] = point->angle == angle.field ? point->sine[k] : negate(point->sine[k]);
  return result;
}

Value Angles::cosine(Value const &angle) const {
  Value result = algebra::cosine(angle);
  if (Point const *point = find(angle)) result.field = point->cosine;
  return result;
}

void Angles::add(Value const &sum, std::span<AnglePart const> parts) {
  Value sine{}, cosine{};
  for (std::size_t k = 0; k < field_points; ++k) {
    Rotation all;
    for (AnglePart const &part : parts) {
      // The hashed point of the part represents a quarter of it.
      Rotation const quarter = {algebra::sine(part.angle).field[k], algebra::cosine(part.angle).field[k]};
      all = all * power(quarter, part.quarters);
    }
    sine.field[k] = all.sine;
    cosine.field[k] = all.cosine;
  }
  set(sum, sine, cosine);
}

void Angles::set(Value const &angle, Value const &sine, Value const &cosine) {
  points_.insert_or_assign(angle.key(), Point{angle.field, sine.field, cosine.field});
}

} // namespace symreal::algebra
