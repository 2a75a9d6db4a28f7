#include "verify/exact_outputs.h"

#include "engine/graph/evaluate.h"

// Functions of Multiprecision are found by argument-dependent lookup.
#define SYMREAL_MATH(function) function
#include "engine/graph/evaluate_in.h"

namespace symreal::program {

Multiprecision evaluate_exact(Op op, Multiprecision const &x, Multiprecision const &y, Multiprecision const &z) {
  return evaluate_in(op, x, y, z);
}

ExactOutputs::ExactOutputs(Graph const &graph, unsigned bits) : graph_(graph) { Multiprecision::set_bits(bits); }

bool ExactOutputs::move_to(std::span<double const> inputs, std::span<double const> parameters,
                           std::span<double const> values) {
  auto const leaf = [&](NodeId, Node const &node, std::vector<Multiprecision> const &) {
    return Multiprecision(node.op == Op::input ? inputs[node.slot()] : parameters[node.slot()]);
  };
  auto wide = evaluate_nodes<Multiprecision>(graph_, values, leaf, [](NodeId, Multiprecision const &) {});
  if (!wide) return false;
  outputs_.clear();
  for (NodeId result : graph_.results) outputs_.push_back((*wide)[result]);
  return true;
}

double ExactOutputs::error_of(std::size_t slot, double number) const {
  Multiprecision const &exact = outputs_[slot];
  return static_cast<double>(fabs(Multiprecision(number) - exact) / fmax(fabs(exact), Multiprecision(1)));
}

} // namespace symreal::program
