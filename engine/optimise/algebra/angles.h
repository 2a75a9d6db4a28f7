// Angles as points of the unit circle over the prime field.
//
// A pseudorandom function of an angle's value gives its point. Related angles are the exception: for integer
// combinations of others or of their quarters the point is the product of those points. So the field satisfies sin(a +
// b) = sin(a) cos(b) + cos(a) sin(b), and structure recovery finds it like any other identity.
#pragma once

#include "engine/optimise/algebra/value.h"

#include <span>
#include <unordered_map>

namespace symreal::algebra {

// The angle times quarters / 4.
struct AnglePart {
  Value angle;
  int quarters;
};

class Angles {
public:
  Value sine(Value const &angle) const;
  Value cosine(Value const &angle) const;

  // Makes the product of the parts' points the point of their sum `sum`.
  void add(Value const &sum, std::span<AnglePart const> parts);
  // Sets the point of an angle.
  void set(Value const &angle, Value const &sine, Value const &cosine);

private:
  struct Point {
    std::array<Residue, field_points> angle, sine, cosine;
  };
  Point const *find(Value const &angle) const;

  std::unordered_map<std::uint64_t, Point> points_; // keyed by Value::key
};

} // namespace symreal::algebra
