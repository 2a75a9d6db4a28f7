// The order of a function's statements.
#pragma once

#include "engine/plan/schedule/schedule.h"
#include "engine/support/small_stack.h"

#include <algorithm>

namespace symreal {

// Puts the variables, given in the order of their nodes, into an order in which every one stands after what it reads
// and after the conditions of its region, and adds the gates. Without regions that is the order of the nodes. A node
// that is needed here or there may be needed for the condition of there: then its gate is released. `is_read`: nodes
// that are found in an array. Iterative, linear.
void order(Graph const &graph, std::vector<char> const &is_read, Placement &placement, FunctionBody &body);

// Calls `visit` with the variables that a use of a node reads: itself, or those in the operations nested there.
template <class IsVariable, class IsRead, class Visit> void for_each_read(Graph const &graph, NodeId use,
                                                                          IsVariable const &is_variable,
                                                                          IsRead const &is_read, Visit const &visit) {
  if (is_variable(use)) return visit(use);
  if (is_read(use)) return;
  SmallStack<NodeId> nested;
  nested.push(use);
  while (!nested.empty()) {
    NodeId const id = nested.pop();
    if (is_variable(id))
      visit(id);
    else if (!is_read(id))
      for (NodeId operand : graph.nodes[id].operand)
        if (operand != no_node) nested.push(operand);
  }
}

// Whether the function finds the node in an array.
inline bool is_read(Schedule const &plan, bool in_compute, NodeId id) {
  return is_leaf(plan.graph->nodes[id].op) || (in_compute && plan.element(id));
}

// Per node: whether it is an operation that the function computes for these.
std::vector<char> needed_operations(Schedule const &plan, bool in_compute, std::vector<NodeId> const &roots);

// Calls `visit` with the operands of the operation that sets a variable.
template <class Visit> void for_each_operand(Schedule const &plan, FunctionBody const &body, bool in_compute,
                                             NodeId variable, Visit const &visit) {
  if (body.regions.is_gate(variable)) {
    for (RegionId alternative : body.regions.alternatives(variable))
      for (Literal const &literal : body.regions.literals(alternative)) visit(literal.condition);
    return;
  }
  if (is_read(plan, in_compute, variable)) return;
  Node const &node = plan.graph->nodes[variable];
  // Which call comes before is a matter of order alone.
  for (std::size_t i = 0; i < (node.op == Op::call_in_order ? 2 : node.operand.size()); ++i)
    if (node.operand[i] != no_node) visit(node.operand[i]);
}

// Whether every statement is computed in any case: none is a gate or stands in a block.
inline bool is_straight(Graph const &graph, FunctionBody const &body) {
  return body.regions.value_count() == graph.nodes.size() &&
         std::ranges::all_of(body.region, [](RegionId region) { return region == everywhere; });
}

// Whether a statement calls an external function: it sets an array.
inline bool is_call_node(Schedule const &plan, FunctionBody const &body, NodeId variable) {
  return !body.regions.is_gate(variable) && is_call(plan.graph->nodes[variable].op);
}

} // namespace symreal
