// Dependences between statements: the variables and arrays that a statement reads.
#pragma once

#include "engine/plan/schedule/schedule.h"
#include "engine/support/small_stack.h"

#include <algorithm>
#include <span>

namespace symreal {

// Whether the function reads the node from an array.
inline bool is_read(Plan const &plan, FunctionKind kind, NodeId id) {
  return is_leaf(plan.graph->nodes[id].op) || (reads_elements(kind) && plan.element(id));
}

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

// Calls `visit` with the operands of the operation that sets a variable; a gate's operands are its conditions.
template <class Visit>
void for_each_operand(Plan const &plan, PlanFunction const &body, NodeId variable, Visit const &visit) {
  if (body.regions.is_gate(variable)) {
    for (RegionId alternative : body.regions.alternatives(variable))
      for (Literal const &literal : body.regions.literals(alternative)) visit(literal.condition);
    return;
  }
  if (is_read(plan, body.kind, variable)) return;
  Node const &node = plan.graph->nodes[variable];
  // The preceding call constrains the order only.
  for (std::size_t i = 0; i < (node.op == Op::call_in_order ? 2 : node.operand.size()); ++i)
    if (node.operand[i] != no_node) visit(node.operand[i]);
}

// Calls `visit` with the variables that must precede a statement of compute: its operands, the conditions of the blocks
// around it, and the preceding call if calls are ordered.
template <class IsVariable, class Visit> void for_each_before(Plan const &plan, PlanFunction const &body,
                                                              std::size_t statement, IsVariable const &is_variable,
                                                              Visit const &visit) {
  NodeId const id = body.variables[statement];
  auto const read = [&](NodeId use) {
    for_each_read(*plan.graph, use, is_variable, [&](NodeId other) { return is_read(plan, body.kind, other); }, visit);
  };
  for (Literal const &literal : body.regions.literals(body.region[statement])) read(literal.condition);
  for_each_operand(plan, body, id, read);
  if (body.regions.is_gate(id)) return;
  Node const &node = plan.graph->nodes[id];
  if (node.op == Op::call_in_order && node.operand[2] != no_node && is_variable(node.operand[2]))
    visit(node.operand[2]);
}

// Per node: whether it is an operation that the function computes for `roots`.
std::vector<char> needed_operations(Plan const &plan, FunctionKind kind, std::vector<NodeId> const &roots);

// Whether a part reads a value that an earlier part of its stage computes. To find all conflicts, ask for every part.
bool waits_for_other_parts(Plan const &plan, PlanFunction const &body, std::size_t part);

// Whether the body is straight-line code: without gates and blocks.
inline bool is_straight(Graph const &graph, PlanFunction const &body) {
  return body.regions.value_count() == graph.nodes.size() &&
         std::ranges::all_of(body.region, [](RegionId region) { return region == everywhere; });
}

// Whether a statement calls an external function, and thus sets an array.
inline bool is_call_node(Plan const &plan, PlanFunction const &body, NodeId variable) {
  return !body.regions.is_gate(variable) && is_call(plan.graph->nodes[variable].op);
}

// Rows of statement numbers, one row per statement, contiguous in one array (compressed sparse rows).
struct StatementRows {
  std::vector<std::size_t> first = {0};
  std::vector<std::uint32_t> all = {};

  std::size_t size() const { return first.size() - 1; }
  std::span<std::uint32_t const> operator[](std::size_t k) const {
    return std::span(all).subspan(first[k], first[k + 1] - first[k]);
  }
  void end_row() { first.push_back(all.size()); }
};

} // namespace symreal
