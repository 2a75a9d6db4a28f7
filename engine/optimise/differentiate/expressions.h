// Builder of derivative expressions, appended to a graph's nodes. A structural zero is no_node and costs nothing.
//
// Simplifies over the reals, 0 * x = 0 and 1 * x = x: these expressions define the derivative, so no bits need
// preserving. A product with a select that has a zero arm becomes a select of a product: multiplied outside, the zero
// times the infinite slope of the arm not taken would be NaN.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"
#include "engine/optimise/differentiate/rules.h"

namespace symreal {

class Expressions {
public:
  // Takes the nodes of `graph`; they keep their ids.
  explicit Expressions(Graph &graph);
  // Returns all nodes to the graph.
  void finish();

  // The original graph.
  Graph const &graph() const { return graph_; }
  Node node(NodeId id) const { return table_[id]; }
  // Gives nodes created from now on the source location of node `id`.
  void place_at(NodeId id);

  NodeId constant(double value) { return table_.constant(value); }
  NodeId input(std::uint32_t slot) { return table_.intern(Node::input(slot)); }
  // Operands and results are no_node for zero.
  NodeId sum(NodeId a, NodeId b);
  NodeId product(NodeId a, NodeId b);
  NodeId quotient(NodeId a, NodeId b); // b is not no_node
  NodeId negative(NodeId a);
  NodeId select(NodeId condition, NodeId yes, NodeId no);
  // Truth value of |a| > |b|.
  NodeId is_larger_magnitude(NodeId a, NodeId b);
  // Calls `use(operand, partial)` for each operand of original node `id` that has a derivative formula; `partial()`
  // builds the partial derivative.
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
  // The node; a constant 0 for no_node.
  NodeId number(NodeId id) { return id == no_node ? constant(0) : id; }

private:
  // Partial derivative of node `id` by its operand `i`, which has a formula.
  NodeId partial(NodeId id, std::size_t i);
  NodeId partial_of_call(NodeId id, std::size_t i);
  NodeId operation(Op op, NodeId a, NodeId b = no_node, NodeId c = no_node);
  NodeId simplified(Op op, NodeId a, NodeId b, NodeId c);
  NodeId made_of(Term const &term, Node const &node, NodeId result);
  NodeId product_within(NodeId a, NodeId b, int depth);
  NodeId intern(Op op, NodeId a, NodeId b, NodeId c);
  bool is(NodeId id, double value) const { return table_[id].is_constant() && table_[id].value() == value; }
  bool is(NodeId id, Op op) const { return table_[id].op == op; }
  NodeId zero_free(NodeId id) const { return id == no_node || is(id, 0.0) ? no_node : id; }

  Graph &graph_;
  NodeTable table_;
  LocationId location_ = no_location;
};

} // namespace symreal
