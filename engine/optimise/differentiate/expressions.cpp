#include "engine/optimise/differentiate/expressions.h"

#include <cmath>

namespace symreal {

Expressions::Expressions(Graph &graph) : graph_(graph) {
  table_.reserve(2 * graph.nodes.size());
  for (Node const &node : graph.nodes) table_.append(node);
}

void Expressions::finish() {
  graph_.nodes = table_.release();
  std::size_t const count = graph_.nodes.size();
  if (!graph_.node_location.empty()) graph_.node_location.resize(count, no_location);
  if (!graph_.node_name.empty()) graph_.node_name.resize(count, no_name);
  if (!graph_.node_exact.empty()) graph_.node_exact.resize(count, 0);
}

void Expressions::place_at(NodeId id) {
  location_ = id < graph_.node_location.size() ? graph_.node_location[id] : no_location;
}

NodeId Expressions::intern(Op op, NodeId a, NodeId b, NodeId c) {
  NodeId const id = table_.intern(table_.operation(op, a, b, c));
  if (!graph_.node_location.empty() && id >= graph_.node_location.size()) {
    graph_.node_location.resize(id + std::size_t{1}, no_location);
    graph_.node_location.back() = location_;
  }
  return id;
}

// A simpler node with the same value, else no_node.
NodeId Expressions::simplified(Op op, NodeId a, NodeId b, NodeId c) {
  switch (op) {
  case Op::neg: return is(a, Op::neg) ? table_[a].operand[0] : no_node;
  case Op::add:
    if (is(a, 0.0)) return b;
    if (is(b, 0.0)) return a;
    if (is(b, Op::neg)) return operation(Op::sub, a, table_[b].operand[0]);
    return is(a, Op::neg) ? operation(Op::sub, b, table_[a].operand[0]) : no_node;
  case Op::sub:
    if (is(b, 0.0)) return a;
    if (is(a, 0.0)) return operation(Op::neg, b);
    return is(b, Op::neg) ? operation(Op::add, a, table_[b].operand[0]) : no_node;
  case Op::mul:
    if (is(a, 0.0) || is(b, 0.0)) return constant(0);
    if (is(a, 1.0)) return b;
    if (is(b, 1.0)) return a;
    if (is(a, -1.0)) return operation(Op::neg, b);
    if (is(b, -1.0)) return operation(Op::neg, a);
    if (is(a, Op::neg)) return operation(Op::neg, operation(Op::mul, table_[a].operand[0], b));
    return is(b, Op::neg) ? operation(Op::neg, operation(Op::mul, a, table_[b].operand[0])) : no_node;
  case Op::div:
    if (is(a, 0.0)) return a;
    if (is(b, 1.0)) return a;
    return is(a, Op::neg) ? operation(Op::neg, operation(Op::div, table_[a].operand[0], b)) : no_node;
  case Op::select:
    if (table_[a].is_constant()) return table_[a].value() != 0 ? b : c;
    if (is(b, Op::select) && table_[b].operand[0] == a) return operation(Op::select, a, table_[b].operand[1], c);
    if (is(c, Op::select) && table_[c].operand[0] == a) return operation(Op::select, a, b, table_[c].operand[2]);
    return b == c ? b : no_node;
  case Op::logical_and:
    if (is(a, 0.0) || is(b, 0.0)) return constant(0);
    return is(a, 1.0) ? b : is(b, 1.0) ? a : no_node;
  case Op::pow:
    if (is(b, 0.0)) return constant(1);
    if (is(b, 1.0)) return a;
    return is(b, 2.0) ? operation(Op::mul, a, a) : no_node;
  default: return no_node;
  }
}

NodeId Expressions::operation(Op op, NodeId a, NodeId b, NodeId c) {
  auto const is_known = [&](NodeId id) { return id == no_node || table_[id].is_constant(); };
  auto const value = [&](NodeId id) { return id == no_node ? 0 : table_[id].value(); };
  if (is_known(a) && is_known(b) && is_known(c))
    if (double const folded = evaluate(op, value(a), value(b), value(c)); std::isfinite(folded))
      return constant(folded);
  if (NodeId const simple = simplified(op, a, b, c); simple != no_node) return simple;
  return intern(op, a, b, c);
}

NodeId Expressions::select(NodeId condition, NodeId yes, NodeId no) {
  return zero_free(operation(Op::select, condition, number(yes), number(no)));
}

NodeId Expressions::sum(NodeId a, NodeId b) {
  a = zero_free(a), b = zero_free(b);
  if (a == no_node || b == no_node) return a == no_node ? b : a;
  if (is(a, Op::select) && is(b, Op::select) && table_[a].operand[0] == table_[b].operand[0]) {
    Node const one = table_[a], other = table_[b];
    bool const is_gate = is(one.operand[1], 0.0) || is(one.operand[2], 0.0);
    if (is_gate || is(other.operand[1], 0.0) || is(other.operand[2], 0.0))
      return select(one.operand[0], sum(one.operand[1], other.operand[1]), sum(one.operand[2], other.operand[2]));
  }
  return zero_free(operation(Op::add, a, b));
}

NodeId Expressions::product(NodeId a, NodeId b) { return product_within(a, b, 0); }

NodeId Expressions::quotient(NodeId a, NodeId b) {
  return a == no_node ? no_node : zero_free(operation(Op::div, a, b));
}

NodeId Expressions::negative(NodeId a) { return a == no_node ? no_node : zero_free(operation(Op::neg, a)); }

NodeId Expressions::is_larger_magnitude(NodeId a, NodeId b) {
  return operation(Op::gt, operation(Op::abs, a), operation(Op::abs, b));
}

// Nesting depth up to which a product is distributed over selects; each level costs a select.
static constexpr int deepest = 8;

NodeId Expressions::product_within(NodeId a, NodeId b, int depth) {
  a = zero_free(a), b = zero_free(b);
  if (a == no_node || b == no_node) return no_node;
  for (auto const &[gate, other] : {std::pair(a, b), std::pair(b, a)}) {
    Node const node = table_[gate];
    if (node.op != Op::select || depth == deepest) continue;
    bool const is_choice = table_[node.operand[1]].is_constant() && table_[node.operand[2]].is_constant();
    if (is_choice || is(node.operand[1], 0.0) || is(node.operand[2], 0.0))
      return select(node.operand[0], product_within(node.operand[1], other, depth + 1),
                    product_within(node.operand[2], other, depth + 1));
  }
  return zero_free(operation(Op::mul, a, b));
}

NodeId Expressions::made_of(Term const &term, Node const &node, NodeId result) {
  switch (term.kind) {
  case Term::Kind::number: return constant(term.number);
  case Term::Kind::variable:
    return term.variable == 'r' ? result : node.operand[static_cast<std::size_t>(term.variable - 'x')];
  case Term::Kind::operation: break;
  }
  std::array<NodeId, 3> operand = {no_node, no_node, no_node};
  for (std::size_t i = 0; i < term.operands.size(); ++i) operand[i] = made_of(term.operands[i], node, result);
  return operation(term.op, operand[0], operand[1], operand[2]);
}

NodeId Expressions::partial(NodeId id, std::size_t i) {
  Node const node = table_[id];
  return zero_free(made_of(derivative_of(node.op, i), node, id));
}

// Partial of a call's result by its numeric argument `i`: calls the derivative function with the same arguments.
NodeId Expressions::partial_of_call(NodeId id, std::size_t i) {
  Node const call = table_[table_[id].operand[0]];
  std::size_t const function = derivative_function(graph_, function_of(graph_, graph_.nodes[table_[id].operand[0]]));
  internal_check(function < graph_.externals.size());
  NodeId const number = constant(static_cast<double>(function));
  NodeId const derivative = intern(Op::call, call.operand[0], number, no_node);
  NodeId const which = constant(static_cast<double>(first_partial(graph_, id) + i));
  return intern(Op::returned, derivative, which, no_node);
}

} // namespace symreal
