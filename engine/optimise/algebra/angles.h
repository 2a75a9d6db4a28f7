// The points of the unit circle over the field that stand for angles.
//
// An angle's point depends on its value alone, and looks random. Only where angles are integer combinations of others,
// or of quarters of them, their points are the products of those others' points: so the field shows that
// sin(a + b) = sin(a) cos(b) + cos(a) sin(b), and structure recovery finds it as it finds all else.
#pragma once

#include "engine/optimise/algebra/value.h"

#include <span>
#include <unordered_map>

namespace symreal::algebra {

// quarters / 4 of an angle.
struct AnglePart {
  Value angle;
  int quarters;
};

class Angles {
public:
  Value sine(Value const &angle) const;
  Value cosine(Value const &angle) const;

  // From now on, the point of the angle with this value, the sum of the parts, is the product of their points;
  void add(Value const &sum, std::span<AnglePart const> parts);
  // is this one.
  void set(Value const &angle, Value const &sine, Value const &cosine);

private:
  struct Point {
    std::array<Residue, field_points> angle, sine, cosine;
  };
  Point const *find(Value const &angle) const;

  std::unordered_map<std::uint64_t, Point> points_; // by Value::key
};

} // namespace symreal::algebra
