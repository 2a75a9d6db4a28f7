#include "engine/optimise/algebra/value.h"

namespace symreal::algebra {

namespace {

template <class Field, class Number> Value each(Field const &field, Number const &number) {
  Value result{};
  for (std::size_t k = 0; k < field_points; ++k) result.field[k] = field(k);
  for (std::size_t k = 0; k < number_points; ++k) result.number[k] = number(k);
  return result;
}

// Pseudorandom number between 0.3 and 1.3.
long double random_number(std::uint64_t key) {
  return 0.3L + static_cast<long double>(mixed(key * 31 + 0x51ED2701u) >> 11) * 0x1p-53L;
}

Residue parameter_of_circle(Residue angle) {
  Residue const t = random_residue(magnitude(angle) ^ 0x55555u);
  return angle == 0 ? 0 : t;
}

} // namespace

Value value_of(double constant) {
  Residue const residue = residue_of(constant);
  return each([&](std::size_t) { return residue; }, [&](std::size_t) { return static_cast<long double>(constant); });
}

Value random_value(std::uint64_t key) {
  return each([&](std::size_t k) { return random_residue(mixed(key) + k * 1000003); },
              [&](std::size_t k) { return random_number(mixed(key) + k * 1000003); });
}

Value random_parameter(std::uint64_t key) {
  return each([&](std::size_t k) { return random_residue(mixed(key ^ 0x7777777777u) + (k == 2 ? 1000003 : 0)); },
              [&](std::size_t k) { return random_number(mixed(key ^ 0x7777777777u) + k * 1000003); });
}

Value operator-(Value const &a) {
  return each([&](std::size_t k) { return negate(a.field[k]); }, [&](std::size_t k) { return -a.number[k]; });
}
Value operator+(Value const &a, Value const &b) {
  return each([&](std::size_t k) { return add(a.field[k], b.field[k]); },
              [&](std::size_t k) { return a.number[k] + b.number[k]; });
}
Value operator*(Value const &a, Value const &b) {
  return each([&](std::size_t k) { return multiply(a.field[k], b.field[k]); },
              [&](std::size_t k) { return a.number[k] * b.number[k]; });
}
Value inverse(Value const &a) {
  return each([&](std::size_t k) { return inverse(a.field[k]); }, [&](std::size_t k) { return 1 / a.number[k]; });
}

Value sine(Value const &a) {
  return each(
      [&](std::size_t k) {
        Residue const t = parameter_of_circle(a.field[k]);
        Residue const s = multiply(multiply(2, t), inverse(add(1, multiply(t, t))));
        return magnitude(a.field[k]) == a.field[k] ? s : negate(s);
      },
      [&](std::size_t k) { return sinl(a.number[k]); });
}
Value cosine(Value const &a) {
  return each(
      [&](std::size_t k) {
        Residue const square = multiply(parameter_of_circle(a.field[k]), parameter_of_circle(a.field[k]));
        return multiply(subtract(1, square), inverse(add(1, square)));
      },
      [&](std::size_t k) { return cosl(a.number[k]); });
}

} // namespace symreal::algebra
