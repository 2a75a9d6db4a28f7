// Algebraic properties of functions: sine and cosine at points of the unit circle, parity, and domains of other
// functions.
#include "engine/optimise/algebra/network.h"

#include <algorithm>

namespace symreal::algebra {

namespace {

enum class Parity : std::uint8_t { none, odd, even };

Parity parity_of(Op op) {
  switch (op) {
  case Op::sin:
  case Op::tan:
  case Op::asin:
  case Op::atan:
  case Op::sinh:
  case Op::tanh:
  case Op::asinh:
  case Op::atanh:
  case Op::erf:
  case Op::cbrt: return Parity::odd;
  case Op::cos:
  case Op::cosh:
  case Op::abs: return Parity::even;
  default: return Parity::none;
  }
}

// Whether the operation is finite for all finite operands. A select shields its arms, so it counts as partial.
bool is_total(Op op) {
  bool const is_exact = op == Op::add || op == Op::sub || op == Op::mul; // exact arithmetic
  return is_exact || op == Op::sin || op == Op::cos ||
         (info(op).has(flag::QUIET) && op != Op::select && op != Op::wide_select);
}

// Pseudorandom value at each point, keyed by the operands' values there.
Value opaque_value(Function const &function, Network const &network) {
  Value result{};
  std::uint64_t all = function.origin;
  for (std::size_t k = 0; k < field_points; ++k) {
    std::uint64_t key = mixed(static_cast<std::uint64_t>(function.op) * 64 + function.arity) + function.origin;
    for (std::size_t i = 0; i < function.arity; ++i) key = mixed(key) + network.value(function.operands[i]).field[k];
    result.field[k] = random_residue(key);
    all = mixed(all) + result.field[k];
  }
  for (std::size_t k = 0; k < number_points; ++k) result.number[k] = random_value(all).number[k];
  return result;
}

} // namespace

Literal Network::function(Function made) {
  bool negative = false;
  if (Parity const parity = parity_of(made.op); parity != Parity::none && made.operands[0].is_negative()) {
    made.operands[0] = -made.operands[0];
    negative = parity == Parity::odd;
  }
  // A function of constants is not folded here.
  Attribute attribute = info(made.op).has(flag::EFFECT) ? Attribute::variable : Attribute::parametric;
  HazardSet rests_on = no_hazard;
  for (std::size_t i = 0; i < made.arity; ++i) {
    NetworkNode const &operand = (*this)[made.operands[i]];
    attribute = std::max(attribute, operand.attribute);
    rests_on = hazards().unite(rests_on, operand.hazards);
  }
  NetworkNode node = {Kind::function, attribute, rests_on, {static_cast<std::uint32_t>(functions_.size())}, {}, {}};
  if (made.op == Op::sin && made.origin == 0)
    node.value = context_->angles.sine(value(made.operands[0]));
  else if (made.op == Op::cos && made.origin == 0)
    node.value = context_->angles.cosine(value(made.operands[0]));
  else
    node.value = opaque_value(made, *this);
  if (!is_total(made.op)) {
    // A partial function shields its operands' hazards except the inputs.
    HazardSet const itself = hazards().of_operation(node.value.key() << 1 | 1);
    node.hazards = hazards().unite(hazards().inputs_in(rests_on), itself);
  }
  functions_.push_back(made);
  return intern(node, 0).negated_if(negative);
}

} // namespace symreal::algebra
