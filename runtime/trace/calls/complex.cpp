// Functions of complex numbers: calls of pure external functions that are always at hand.
#include "engine/graph/complex_function.h"
#include "runtime/trace/decisions/policy.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"

#include <symreal/complex.h>

#include <array>

namespace symreal::detail {

using trace::Externals;
using trace::Pool;

bool products_are_formulas() noexcept { return trace::floating_point() != FloatingPoint::strict; }

ComplexParts compute_parts(ComplexFunction function, ComplexParts x, ComplexParts y) noexcept {
  std::array<RealNumber, 4> const all = {x.real, x.imaginary, y.real, y.imaginary};
  std::span const operands(all.data(), std::size_t{2} * info(function).arity);
  ++executed[static_cast<unsigned>(Op::call)];
  Pool &pool = Pool::current();
  std::array<double, 4> arguments{};
  bool is_symbolic = false, is_missing = false;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    is_symbolic |= operands[k].is_node();
    arguments[k] = pool.carried_value(operands[k]);
    is_missing |= trace::is_missing(arguments[k]);
  }
  std::array<double, 2> results{missing_value(), missing_value()};
  if (!is_missing) evaluate(function, std::span(arguments.data(), operands.size()), results);
  if (!is_symbolic) return {results[0], results[1]};

  void const *const caller = __builtin_return_address(0);
  NodeTable const &nodes = pool.nodes();
  NodeId list = pool.node(0.0);
  for (RealNumber operand : operands) {
    NodeId const value = pool.node(operand); // before the table is asked: a constant may be new
    list = pool.node(pool.leaf(nodes.operation(Op::argument, list, value), 0, caller));
  }
  NodeId const called = pool.node(static_cast<double>(Externals::current().number(external_of(function))));
  NodeId const call = pool.node(pool.leaf(nodes.operation(Op::call, list, called), 0, caller));
  auto part = [&](double number, double value) {
    NodeId const which = pool.node(number);
    return pool.leaf(nodes.operation(Op::returned, call, which), value, caller);
  };
  RealNumber const real = part(0, results[0]);
  return {real, part(1, results[1])};
}

} // namespace symreal::detail
