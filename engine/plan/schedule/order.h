// Statement order of a function.
#pragma once

#include "engine/plan/schedule/schedule.h"
#include "engine/support/small_stack.h"

#include <algorithm>

namespace symreal {

// Sorts the variables, given in node order, so that each follows its operands and the conditions of its region, and
// adds the gates. Without regions the node order stays. A gate of alternatives is released if its alternatives depend
// on a node that it guards. `is_read`: nodes that are read from arrays. Iterative; linear time.
void order(Graph const &graph, std::vector<char> const &is_read, Placement &placement, FunctionBody &body);

// Calls `visit` with the variables that a use of a node reads: the node itself, or those in its nested expression.
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

// Whether the function reads the node from an array.
inline bool is_read(Schedule const &plan, bool in_compute, NodeId id) {
  return is_leaf(plan.graph->nodes[id].op) || (in_compute && plan.element(id));
}

// Per node: whether it is an operation that the function computes for `roots`.
std::vector<char> needed_operations(Schedule const &plan, bool in_compute, std::vector<NodeId> const &roots);

// Calls `visit` with the operands of the operation that sets a variable; a gate's operands are its conditions.
template <class Visit> void for_each_operand(Schedule const &plan, FunctionBody const &body, bool in_compute,
                                             NodeId variable, Visit const &visit) {
  if (body.regions.is_gate(variable)) {
    for (RegionId alternative : body.regions.alternatives(variable))
      for (Literal const &literal : body.regions.literals(alternative)) visit(literal.condition);
    return;
  }
  if (is_read(plan, in_compute, variable)) return;
  Node const &node = plan.graph->nodes[variable];
  // The preceding call constrains the order only.
  for (std::size_t i = 0; i < (node.op == Op::call_in_order ? 2 : node.operand.size()); ++i)
    if (node.operand[i] != no_node) visit(node.operand[i]);
}

// Whether the body is straight-line code: without gates and blocks.
inline bool is_straight(Graph const &graph, FunctionBody const &body) {
  return body.regions.value_count() == graph.nodes.size() &&
         std::ranges::all_of(body.region, [](RegionId region) { return region == everywhere; });
}

// Whether a statement calls an external function, and thus sets an array.
inline bool is_call_node(Schedule const &plan, FunctionBody const &body, NodeId variable) {
  return !body.regions.is_gate(variable) && is_call(plan.graph->nodes[variable].op);
}

} // namespace symreal
