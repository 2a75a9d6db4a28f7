// Reference semantics over number types wider than double. Each including file gets its own copy, and may define
// SYMREAL_MATH beforehand as the math functions of its type.
#pragma once

#include "engine/graph/evaluate.h"

#include <symreal/integer_functions.h>

#include <cmath>
#include <optional>
#include <vector>

namespace symreal {
namespace {

// Relation of an operation to real arithmetic.
enum class Reality : std::uint8_t {
  formula, // a function of real numbers
  jump,    // a piecewise constant function
  none,    // depends on the representation of numbers, or on non-numbers
};

Reality reality_of(Op op) {
  OperationInfo const &row = info(op);
  if (row.has(flag::OPAQUE | flag::WIDE | flag::TAKES_WIDE)) return Reality::none;
  switch (op) {
  case Op::f32:
  case Op::nextafter: return Reality::none;
  case Op::floor:
  case Op::ceil:
  case Op::trunc:
  case Op::round:
  case Op::rint:
  case Op::logb: return Reality::jump;
  default:
    return row.has(flag::BOOLEAN) || row.form == Form::local || row.form == Form::cast ? Reality::jump
                                                                                       : Reality::formula;
  }
}

[[maybe_unused]] int opaque() { return 0; }

// A conversion to integer truncates, so it must not see a number rounded up to an integer.
template <class Number> double cut_off(Number const &x) {
  double const nearest = static_cast<double>(x);
  bool const is_beyond = nearest > 0 ? x < nearest : x > nearest;
  return is_beyond ? std::nextafter(nearest, 0.0) : nearest;
}

// Evaluates in `Number`, except for integer operations of the table, which stay in double.
template <class Number> Number evaluate_in(Op op, Number const &x, Number const &y, Number const &z) {
  using namespace flag;
  (void)z;
  switch (op) {
#define OPERATION(id, arity, form, c, precedence, evaluate, derivative, cost, flags, domain, doc)                      \
  case Op::id:                                                                                                         \
    if constexpr ((Form::form == Form::infix || Form::form == Form::prefix || Form::form == Form::call ||              \
                   Form::form == Form::select) &&                                                                      \
                  ((flags) & (WIDE | TAKES_WIDE)) == 0)                                                                \
      return static_cast<Number>(evaluate);                                                                            \
    else                                                                                                               \
      break;
#include <symreal/operations.def>
#undef OPERATION
  default: break;
  }
  return static_cast<Number>(evaluate(op, cut_off(x), cut_off(y), cut_off(z)));
}

// Choice of an operation with jumps; equal choices lie between the same jumps.
template <class Number> Number choice_of(Op op, Number const &x, Number const &y, Number const &result) {
  using std::signbit, std::trunc, std::rint;
  switch (op) {
  case Op::copysign: return static_cast<Number>(signbit(y) ? 1 : 0);
  case Op::fmod: return trunc(static_cast<Number>(x / y));
  case Op::remainder: return rint(static_cast<Number>(x / y));
  default: return reality_of(op) == Reality::jump ? result : static_cast<Number>(0);
  }
}

// One number per `active` node; `values`: those in double precision. `leaf` gives the numbers of inputs, parameters and
// calls; `moved` may change each result. Nullopt if a node makes a choice other than in double precision and
// `otherwise` rejects it.
template <class Number, class Leaf, class Moved, class Otherwise>
std::optional<std::vector<Number>> evaluate_nodes(Graph const &graph, std::span<double const> values,
                                                  std::span<char const> active, Leaf const &leaf, Moved const &moved,
                                                  Otherwise const &otherwise) {
  std::vector<Number> wide(graph.nodes.size());
  Number const zero{};
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!active[id]) continue;
    if (node.op == Op::constant) {
      wide[id] = static_cast<Number>(node.value());
      continue;
    }
    if (is_leaf(node.op) || reality_of(node.op) == Reality::none) {
      wide[id] = leaf(static_cast<NodeId>(id), node, wide);
      continue;
    }
    auto const operand = [&](std::size_t i) -> Number const & {
      return node.operand[i] == no_node ? zero : wide[node.operand[i]];
    };
    auto const in_double = [&](std::size_t i) { return node.operand[i] == no_node ? 0 : values[node.operand[i]]; };
    wide[id] = evaluate_in<Number>(node.op, operand(0), operand(1), operand(2));
    double const chosen = choice_of<double>(node.op, in_double(0), in_double(1), values[id]);
    if (choice_of<Number>(node.op, operand(0), operand(1), wide[id]) != chosen && !otherwise(static_cast<NodeId>(id)))
      return std::nullopt;
    moved(static_cast<NodeId>(id), wide[id]);
  }
  return wide;
}

// Likewise, with every other choice rejected.
template <class Number, class Leaf, class Moved> std::optional<std::vector<Number>>
evaluate_nodes(Graph const &graph, std::span<double const> values, Leaf const &leaf, Moved const &moved) {
  return evaluate_nodes<Number>(graph, values, active_nodes(graph, values), leaf, moved, [](NodeId) { return false; });
}

} // namespace
} // namespace symreal
