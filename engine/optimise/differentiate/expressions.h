// Derivative expressions as nodes behind those of a graph. What is structurally zero is no node, and costs nothing.
//
// Of real numbers, 0 * x = 0 and 1 * x = x: a derivative is defined by these expressions, so no bits are there to keep.
// What is not computed where it is not selected must not be multiplied either: 0 times the infinite slope of an arm
// that was not taken would be NaN. So a product with a select that has a zero arm is that select of a product.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"
#include "engine/optimise/differentiate/calls.h"
#include "engine/optimise/differentiate/rules.h"
#include "engine/optimise/passes/term.h"

namespace symreal {

class Expressions {
public:
  // `graph` gives its nodes away; they keep their numbers.
  explicit Expressions(Graph &graph);
  // Gives all nodes back.
  void finish();

  // As it was.
  Graph const &graph() const { return graph_; }
  std::size_t size() const { return table_.size(); }
  Node node(NodeId id) const { return table_[id]; }
  // What is made from now on has the place of this node.
  void place_at(NodeId id);

  NodeId constant(double value) { return table_.constant(value); }
  NodeId input(std::uint32_t slot) { return table_.intern(Node::input(slot)); }
  // Each operand may be no_node, for zero, and so may the result.
  NodeId sum(NodeId a, NodeId b);
  NodeId product(NodeId a, NodeId b);
  NodeId quotient(NodeId a, NodeId b); // b is a node
  NodeId negative(NodeId a);
  // Whether |a| > |b|, as a truth value; and the one or the other by it.
  NodeId is_larger_magnitude(NodeId a, NodeId b);
  NodeId choice(NodeId condition, NodeId yes, NodeId no) { return select(condition, yes, no); }
  // Node `id` of the graph as it was: calls `use(operand, partial)` with each number that it depends on by a formula,
  // and how to get its derivative by it.
  template <class Use> void for_each_slope(NodeId id, Use const &use) {
    Node const node = table_[id];
    if (node.op == Op::returned) {
      std::vector<NodeId> const arguments = differentiable_arguments(graph_, id);
      for (std::size_t i = 0; i < arguments.size(); ++i) use(arguments[i], [&] { return partial_of_call(id, i); });
      return;
    }
    for (std::size_t i = 0; i < arity(node.op); ++i)
      if (slope_of(node.op, i) == Slope::formula) use(node.operand[i], [&] { return partial(id, i); });
  }
  // The derivative of node `id` by its operand `i`, which has a formula.
  NodeId partial(NodeId id, std::size_t i);
  // The node, or a zero that stands in its place.
  NodeId number(NodeId id) { return id == no_node ? constant(0) : id; }

private:
  NodeId partial_of_call(NodeId id, std::size_t i);
  NodeId operation(Op op, NodeId a, NodeId b = no_node, NodeId c = no_node);
  NodeId simplified(Op op, NodeId a, NodeId b, NodeId c);
  NodeId made_of(Term const &term, Node const &node, NodeId result);
  NodeId product_within(NodeId a, NodeId b, int depth);
  NodeId select(NodeId condition, NodeId yes, NodeId no);
  NodeId intern(Op op, NodeId a, NodeId b, NodeId c);
  bool is(NodeId id, double value) const { return table_[id].is_constant() && table_[id].value() == value; }
  bool is(NodeId id, Op op) const { return table_[id].op == op; }
  NodeId zero_free(NodeId id) const { return id == no_node || is(id, 0.0) ? no_node : id; }

  Graph &graph_;
  NodeTable table_;
  LocationId location_ = no_location;
};

} // namespace symreal
