#include "engine/plan/schedule/numbering.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace symreal {

Numbering::Numbering(bool zeros_have_signs)
    : zeros_have_signs_(zeros_have_signs),
      zero_(constant(0)),
      one_(constant(1)) {}

NumberedValue Numbering::constant(double value) {
  bool const has_sign = zeros_have_signs_ || value != 0;
  return {values_.constant(std::fabs(value)), has_sign && std::signbit(value)};
}

NumberedValue Numbering::element(std::uint32_t array, std::size_t index) {
  return {number(Op::input, {array, static_cast<NodeId>(index), static_cast<NodeId>(index >> 32)}), false};
}

NumberedValue Numbering::operation(Op op, std::array<NumberedValue, 3> operands) {
  auto const known = std::ranges::find_if_not(operands, &NumberedValue::is_known) - operands.begin();
  if (static_cast<std::size_t>(known) < arity(op)) return {};
  auto const &[x, y, z] = operands;
  switch (op) {
  case Op::neg: return !zeros_have_signs_ && x == zero_ ? x : -x;
  case Op::sub: return sum(x, operation(Op::neg, {y, {}, {}}));
  case Op::add: return sum(x, y);
  case Op::mul:
  case Op::div: return product(op, x, y);
  case Op::abs: return {number(op, {x.number, no_node, no_node}), false};
  default: return {number(op, {with_sign(x), with_sign(y), with_sign(z)}), false};
  }
}

NumberedValue Numbering::sum(NumberedValue x, NumberedValue y) {
  if (y.number < x.number || (x.number == y.number && x.negated)) std::swap(x, y);
  bool negated = false;
  if (!zeros_have_signs_) {
    if (x == -y) return zero_;
    if (x == zero_) return y;
    if (y == zero_) return x;
    negated = std::exchange(x.negated, false);
    y.negated = y.negated != negated;
  }
  if (x.negated && !y.negated) std::swap(x, y);
  if (y.negated && !x.negated) return {number(Op::sub, {x.number, y.number, no_node}), negated};
  return {number(Op::add, {with_sign(x), with_sign(y), no_node}), negated};
}

NumberedValue Numbering::product(Op op, NumberedValue x, NumberedValue y) {
  bool const negated = x.negated != y.negated;
  x.negated = y.negated = false;
  if (!zeros_have_signs_ && (x == zero_ || (op == Op::mul && y == zero_))) return zero_;
  if (op == Op::mul && x == one_) return {y.number, negated};
  if (y == one_) return {x.number, negated};
  if (op == Op::mul && y.number < x.number) std::swap(x, y);
  return {number(op, {x.number, y.number, no_node}), negated};
}

NodeId Numbering::with_sign(NumberedValue value) {
  return value.negated ? number(Op::neg, {value.number, no_node, no_node}) : value.number;
}

NodeId Numbering::number(Op op, std::array<NodeId, 3> operands) {
  return values_.intern({op, Attribute::variable, operands});
}

} // namespace symreal
