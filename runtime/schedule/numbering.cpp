#include "schedule/numbering.h"

#include <bit>
#include <cmath>
#include <utility>

namespace symreal {

static std::uint64_t word(Op op) { return static_cast<std::uint64_t>(op); }

static void order(NumberedValue &x, NumberedValue &y) {
  if (y.word() < x.word()) std::swap(x, y);
}

NumberedValue Numbering::constant(double value) {
  std::uint64_t const bits = std::bit_cast<std::uint64_t>(std::fabs(value));
  bool const has_sign = zeros_have_signs_ || value != 0;
  return {number({word(Op::constant), bits, 0, 0}), has_sign && std::signbit(value)};
}

NumberedValue Numbering::element(std::uint32_t array, std::size_t index) {
  return {number({word(Op::input), array, index, 0}), false};
}

NumberedValue Numbering::operation(Op op, std::array<NumberedValue, 3> operands) {
  auto const &[x, y, z] = operands;
  switch (op) {
  case Op::neg: return !zeros_have_signs_ && x == constant(0) ? x : -x;
  case Op::sub: return sum(x, operation(Op::neg, {y, {}, {}}));
  case Op::add: return sum(x, y);
  case Op::mul:
  case Op::div: return product(op, x, y);
  case Op::abs: return {number({word(op), x.number, 0, 0}), false};
  default: return {number({word(op), x.word(), y.word(), z.word()}), false};
  }
}

NumberedValue Numbering::sum(NumberedValue x, NumberedValue y) {
  order(x, y);
  if (zeros_have_signs_) return {number({word(Op::add), x.word(), y.word(), 0}), false};
  if (x == -y) return constant(0);
  if (x == constant(0)) return y;
  if (y == constant(0)) return x;
  bool const negated = x.negated;
  if (negated) x = -x, y = -y;
  return {number({word(Op::add), x.word(), y.word(), 0}), negated};
}

NumberedValue Numbering::product(Op op, NumberedValue x, NumberedValue y) {
  bool const negated = x.negated != y.negated;
  x.negated = y.negated = false;
  if (!zeros_have_signs_ && (x == constant(0) || (op == Op::mul && y == constant(0)))) return constant(0);
  if (op == Op::mul && x == constant(1)) return {y.number, negated};
  if (y == constant(1)) return {x.number, negated};
  if (op == Op::mul) order(x, y);
  return {number({word(op), x.word(), y.word(), 0}), negated};
}

std::size_t Numbering::Hash::operator()(Key const &key) const {
  std::uint64_t hash = 0;
  for (std::uint64_t part : key) hash = (std::rotl(hash, 23) ^ part) * 0x9E3779B97F4A7C15;
  return hash ^ hash >> 32;
}

std::uint32_t Numbering::number(Key const &key) {
  return numbers_.try_emplace(key, static_cast<std::uint32_t>(numbers_.size())).first->second;
}

} // namespace symreal
