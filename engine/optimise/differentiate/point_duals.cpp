#include "engine/optimise/differentiate/point_duals.h"

#include "engine/graph/call_results.h"
#include "engine/graph/extended.h"
#include "engine/graph/opaque.h"
#include "engine/optimise/differentiate/calls.h"
#include "engine/optimise/differentiate/rules.h"

namespace symreal {

namespace {

struct Dual {
  long double value = 0, slope = 0;
};
using Duals = std::array<Dual, 4>; // the operands, then the result

// Product in which 0 absorbs infinities, as in the arm of a select that is not taken.
long double times(long double a, long double b) { return a == 0 || b == 0 ? 0 : a * b; }

Dual evaluate_dual(Op op, Duals const &operands);

Dual evaluate_dual(Term const &term, Duals const &duals) {
  switch (term.kind) {
  case Term::Kind::number: return {term.number, 0};
  case Term::Kind::variable: return duals[term.variable == 'r' ? 3 : static_cast<std::size_t>(term.variable - 'x')];
  case Term::Kind::operation: break;
  }
  Duals operands;
  for (std::size_t i = 0; i < term.operands.size(); ++i) operands[i] = evaluate_dual(term.operands[i], duals);
  return evaluate_dual(term.op, operands);
}

// Recursion is shallow: terms of the operation table are a few levels deep.
Dual evaluate_dual(Op op, Duals const &operands) {
  Dual result{evaluate_extended(op, operands[0].value, operands[1].value, operands[2].value), 0};
  Duals plain;
  for (std::size_t i = 0; i < 3; ++i) plain[i].value = operands[i].value;
  plain[3].value = result.value;
  for (std::size_t i = 0; i < arity(op); ++i)
    if (operands[i].slope != 0 && slope_of(op, i) == Slope::formula)
      result.slope += times(evaluate_dual(derivative_of(op, i), plain).value, operands[i].slope);
  return result;
}

} // namespace

PointDuals::PointDuals(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters,
                       int order, CallExternal const &call)
    : graph_(graph),
      value_(graph.nodes.size(), 0),
      slope_(graph.nodes.size()) {
  CallResults calls(graph, call);
  auto const results = [&](NodeId of, std::size_t function) -> std::vector<double> & {
    return calls.of(of, function, [&](NodeId argument) { return static_cast<double>(value_[argument]); });
  };
  for (std::size_t id = 0; id < value_.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (node.op == Op::constant) value_[id] = node.value();
    if (node.op == Op::input) value_[id] = inputs[node.slot()];
    if (node.op == Op::parameter) value_[id] = parameters[node.slot()];
    if (node.op == Op::returned) {
      NodeId const called = node.operand[0];
      std::size_t const function = function_of(graph, graph.nodes[called]);
      value_[id] = results(called, function)[result_of(graph, node)];
      CallSlopes slopes{differentiable_arguments(graph, static_cast<NodeId>(id)), {}, {}};
      std::size_t const count = slopes.arguments.size();
      if (count == 0) continue;
      std::size_t const first = first_partial(graph, static_cast<NodeId>(id));
      std::size_t const derivative = derivative_function(graph, function);
      auto const take = [](std::vector<double> const &all, std::size_t from, std::size_t number) {
        auto const begin = all.begin() + static_cast<std::ptrdiff_t>(from);
        return Vector(begin, begin + static_cast<std::ptrdiff_t>(number));
      };
      slopes.first = take(results(called, derivative), first, count);
      if (std::size_t const second = derivative_function(graph, derivative); second != graph.externals.size())
        slopes.second = take(results(called, second), first * count, count * count);
      call_slopes_.emplace(static_cast<NodeId>(id), std::move(slopes));
      continue;
    }
    if (is_leaf(node.op) || node.op == Op::argument || node.op == Op::call) continue;
    Duals duals;
    for (std::size_t i = 0; i < arity(node.op); ++i) duals[i].value = value_[node.operand[i]];
    duals[3].value = value_[id] = evaluate_extended(node.op, duals[0].value, duals[1].value, duals[2].value);
    for (std::size_t i = 0; i < arity(node.op); ++i)
      if (slope_of(node.op, i) == Slope::formula) slope_[id][i] = evaluate_dual(derivative_of(node.op, i), duals).value;
    if (order > 1) add_curvature(static_cast<NodeId>(id));
  }
}

void PointDuals::add_curvature(NodeId id) {
  Node const &node = graph_.nodes[id];
  if (node.op == Op::add || node.op == Op::sub || node.op == Op::neg) return;
  Curvature curvature{id, {}};
  bool is_bent = false;
  for (std::size_t j = 0; j < arity(node.op); ++j) {
    Duals duals;
    for (std::size_t i = 0; i < arity(node.op); ++i) duals[i] = {value_[node.operand[i]], i == j ? 1.0L : 0.0L};
    duals[3] = {value_[id], slope_[id][j]};
    for (std::size_t i = 0; i < arity(node.op); ++i) {
      if (slope_of(node.op, i) != Slope::formula) continue;
      curvature.by[i][j] = evaluate_dual(derivative_of(node.op, i), duals).slope;
      is_bent |= curvature.by[i][j] != 0;
    }
  }
  if (is_bent) curvatures_.push_back(curvature);
}

PointDuals::Vector PointDuals::tangents(Vector const &direction) const {
  Vector tangent(value_.size(), 0);
  for (std::size_t id = 0; id < tangent.size(); ++id) {
    Node const &node = graph_.nodes[id];
    if (node.op == Op::input) tangent[id] = direction[node.slot()];
    if (is_leaf(node.op)) continue;
    for (std::size_t i = 0; i < arity(node.op); ++i) tangent[id] += times(slope_[id][i], tangent[node.operand[i]]);
    if (auto const found = call_slopes_.find(static_cast<NodeId>(id)); found != call_slopes_.end())
      for (std::size_t i = 0; i < found->second.arguments.size(); ++i)
        tangent[id] += times(found->second.first[i], tangent[found->second.arguments[i]]);
  }
  return tangent;
}

PointDuals::Vector PointDuals::forward(Vector const &direction) const {
  Vector const tangent = tangents(direction);
  Vector result;
  for (NodeId const output : graph_.results) result.push_back(tangent[output]);
  return result;
}

PointDuals::Vector PointDuals::reverse(Vector const &weights) const {
  Vector adjoint(value_.size(), 0), result(graph_.input_count(), 0);
  for (std::size_t k = 0; k < weights.size(); ++k) adjoint[graph_.results[k]] += weights[k];
  for (std::size_t id = adjoint.size(); id-- > 0;) {
    Node const &node = graph_.nodes[id];
    if (node.op == Op::input) result[node.slot()] += adjoint[id];
    if (is_leaf(node.op) || adjoint[id] == 0) continue;
    for (std::size_t i = 0; i < arity(node.op); ++i) adjoint[node.operand[i]] += times(slope_[id][i], adjoint[id]);
    if (auto const found = call_slopes_.find(static_cast<NodeId>(id)); found != call_slopes_.end())
      for (std::size_t i = 0; i < found->second.arguments.size(); ++i)
        adjoint[found->second.arguments[i]] += times(found->second.first[i], adjoint[id]);
  }
  return result;
}

PointDuals::Vector PointDuals::second(Vector const &weights, Vector const &direction) const {
  Vector const tangent = tangents(direction);
  std::vector<Dual> adjoint(value_.size());
  Vector result(graph_.input_count(), 0);
  for (std::size_t k = 0; k < weights.size(); ++k) adjoint[graph_.results[k]].value += weights[k];
  auto bent = curvatures_.rbegin();
  for (std::size_t id = adjoint.size(); id-- > 0;) {
    Node const &node = graph_.nodes[id];
    while (bent != curvatures_.rend() && bent->node > id) ++bent;
    auto const [weight, change] = adjoint[id];
    if (node.op == Op::input) result[node.slot()] += change;
    if (is_leaf(node.op) || (weight == 0 && change == 0)) continue;
    if (auto const found = call_slopes_.find(static_cast<NodeId>(id)); found != call_slopes_.end()) {
      auto const &[arguments, first, second] = found->second;
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        Dual &sum = adjoint[arguments[i]];
        sum.value += times(weight, first[i]);
        sum.slope += times(change, first[i]);
        for (std::size_t j = 0; j < arguments.size() && !second.empty(); ++j)
          sum.slope += times(weight, times(second[i * arguments.size() + j], tangent[arguments[j]]));
      }
      continue;
    }
    bool const is_bent = bent != curvatures_.rend() && bent->node == id;
    for (std::size_t i = 0; i < arity(node.op); ++i) {
      Dual &sum = adjoint[node.operand[i]];
      sum.value += times(weight, slope_[id][i]);
      sum.slope += times(change, slope_[id][i]);
      for (std::size_t j = 0; is_bent && j < arity(node.op); ++j)
        sum.slope += times(weight, times(bent->by[i][j], tangent[node.operand[j]]));
    }
  }
  return result;
}

} // namespace symreal
