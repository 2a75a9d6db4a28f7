#include "engine/optimise/algebra/parameter_columns.h"

#include <cmath>
#include <utility>

namespace symreal::algebra {

namespace {

// Arithmetic of one kind of number.
struct InField {
  using Number = Residue;
  static Number zero() { return 0; }
  static Number one() { return 1; }
  static Number sum(Number a, Number b) { return add(a, b); }
  static Number product(Number a, Number b) { return multiply(a, b); }
  static Number quotient(Number a, Number b) { return multiply(a, inverse(b)); }
  static Number signed_by(Literal literal, Number a) { return literal.is_negative() ? negate(a) : a; }
};

struct InNumbers {
  using Number = long double;
  static Number zero() { return 0; }
  static Number one() { return 1; }
  static Number sum(Number a, Number b) { return a + b; }
  static Number product(Number a, Number b) { return a * b; }
  static Number quotient(Number a, Number b) { return a / b; }
  static Number signed_by(Literal literal, Number a) { return literal.is_negative() ? -a : a; }
};

} // namespace

ParameterColumns::ParameterColumns(Network const &network)
    : network_(network),
      column_(network.size(), no_index),
      is_linear_(network.size(), 0),
      is_used_(network.size(), 0) {
  std::vector<char> const live = live_nodes(network);
  for (Index node = 0; node < network.size(); ++node)
    if (live[node]) classify(node);
  for (Literal root : network.roots) add_sum(root);
}

// Records a linear value that a nonlinear node uses, so that it must keep its value.
void ParameterColumns::add_sum(Literal literal) {
  Index const node = literal.node();
  if (is_linear_[node] && !std::exchange(is_used_[node], char{1})) sums_.push_back(node);
}

void ParameterColumns::classify(Index index) {
  NetworkNode const &node = network_[index];
  if (node.attribute == Attribute::constant) return;
  auto linear = [&](Literal literal) { return is_linear_[literal.node()] != 0; };
  auto is_number = [&](Literal literal) { return network_[literal].attribute == Attribute::constant; };
  if (node.is_free()) {
    // Nodes that may be infinite stay unchanged.
    if (node.hazards != no_hazard) return;
    bool const is_sum =
        node.kind == Kind::sum && (linear(node.a) || is_number(node.a)) && (linear(node.b) || is_number(node.b));
    bool const is_multiple =
        node.kind == Kind::product && (is_number(node.a) || is_number(node.b)) && (linear(node.a) || linear(node.b));
    is_linear_[index] = 1;
    if (is_sum || is_multiple) return;
    column_[index] = static_cast<Index>(parameters_.size());
    parameters_.push_back(index);
    return;
  }
  switch (node.kind) {
  case Kind::sum: is_linear_[index] = linear(node.a) || linear(node.b); break;
  case Kind::product:
    is_linear_[index] = linear(node.a) != linear(node.b);
    if (!linear(node.a) || !linear(node.b)) break;
    add_sum(node.a);
    add_sum(node.b);
    break;
  case Kind::quotient:
    is_linear_[index] = linear(node.a) && !linear(node.b);
    if (!linear(node.b)) break;
    add_sum(node.a);
    add_sum(node.b);
    break;
  default: network_.for_each_operand(node, [&](Literal operand) { add_sum(operand); });
  }
}

// Evaluates all nodes at a point, where inputs and parameters get new random values; nonlinear nodes may depend on
// parameters.
void ParameterColumns::evaluate(std::uint64_t point) {
  residue_.assign(network_.size(), 0);
  number_.assign(network_.size(), 0);
  for (Index index = 0; index < network_.size(); ++index) {
    NetworkNode const &node = network_[index];
    auto compute = [&]<class In>(In, auto &values) {
      auto of = [&](Literal literal) { return In::signed_by(literal, values[literal.node()]); };
      if (node.kind == Kind::sum) values[index] = In::sum(of(node.a), of(node.b));
      if (node.kind == Kind::product) values[index] = In::product(of(node.a), of(node.b));
      if (node.kind == Kind::quotient) values[index] = In::quotient(of(node.a), of(node.b));
    };
    if (node.attribute == Attribute::constant) {
      residue_[index] = node.value.field[0];
      number_[index] = node.value.number[0];
    } else if (node.is_arithmetic()) {
      compute(InField{}, residue_);
      compute(InNumbers{}, number_);
    } else {
      Value value = random_value(mixed(node.value.field[0]) + point);
      if (node.kind == Kind::function) {
        Function const &function = network_.function_of(node);
        Literal const angle = function.operands[0];
        Value operand{};
        operand.field[0] = InField::signed_by(angle, residue_[angle.node()]);
        operand.number[0] = InNumbers::signed_by(angle, number_[angle.node()]);
        if (function.op == Op::sin) value = sine(operand);
        if (function.op == Op::cos) value = cosine(operand);
      }
      residue_[index] = value.field[0];
      number_[index] = value.number[0];
    }
  }
}

// Reverse sweep from each sum: its derivative by each linear node.
void ParameterColumns::make_rows(std::uint64_t point) {
  evaluate(point);
  residues_.clear();
  numbers_.clear();
  auto row_of = [&]<class In>(In, Index sum, auto const &values) {
    using Number = typename In::Number;
    std::vector<Number> growth(sum + 1, In::zero()), row(parameters_.size(), In::zero());
    growth[sum] = In::one();
    for (Index index = sum + 1; index-- > 0;) {
      Number const all = growth[index];
      if (all == In::zero() || !is_linear_[index]) continue;
      if (is_parameter(index)) {
        row[column_[index]] = all;
        continue;
      }
      NetworkNode const &node = network_[index];
      auto hand_on = [&](Literal literal, Number factor) {
        Number &growth_of = growth[literal.node()];
        if (is_linear_[literal.node()])
          growth_of = In::sum(growth_of, In::signed_by(literal, In::product(all, factor)));
      };
      auto of = [&](Literal literal) { return In::signed_by(literal, values[literal.node()]); };
      if (node.kind == Kind::sum) {
        hand_on(node.a, In::one());
        hand_on(node.b, In::one());
      } else if (node.kind == Kind::product) {
        hand_on(node.a, of(node.b));
        hand_on(node.b, of(node.a));
      } else {
        hand_on(node.a, In::quotient(In::one(), of(node.b)));
      }
    }
    return row;
  };
  for (Index sum : sums_) {
    residues_.push_back(row_of(InField{}, sum, residue_));
    numbers_.push_back(row_of(InNumbers{}, sum, number_));
  }
}

} // namespace symreal::algebra
