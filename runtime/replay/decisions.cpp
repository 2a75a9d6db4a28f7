#include "runtime/replay/decisions.h"

#include <algorithm>

namespace symreal {

static bool is_joint(Op op) { return !is_leaf(op) && info(op).has(flag::LOGICAL); }

static bool is_select(Op op) { return op == Op::select || op == Op::wide_select; }

std::vector<Decision> decisions_of(Graph const &graph) {
  // A location where the node is, or belongs to, a condition.
  std::vector<char> is_condition(graph.nodes.size(), 0);
  std::vector<Decision> of_node(graph.nodes.size());
  auto note = [&](NodeId id, LocationId location, bool is_guards) {
    if (is_condition[id] && (of_node[id].is_guards || !is_guards)) return;
    is_condition[id] = 1;
    of_node[id] = {id, location, is_guards};
  };
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (live[id] && is_select(node.op))
      note(node.operand[0], graph.node_location.empty() ? no_location : graph.node_location[id], false);
  }
  for (Guard const &guard : graph.guards) note(guard.condition, guard.location, true);
  std::vector<Decision> decisions;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!is_condition[id] || node.attribute == Attribute::constant) continue;
    if (!is_joint(node.op))
      decisions.push_back(of_node[id]);
    else
      for (NodeId operand : node.operand)
        if (operand != no_node) note(operand, of_node[id].location, of_node[id].is_guards);
  }
  std::ranges::reverse(decisions);
  return decisions;
}

double margin_of(Graph const &graph, NodeId condition, std::span<double const> values) {
  Node const &node = graph.nodes[condition];
  bool const compares = !is_leaf(node.op) && info(node.op).has(flag::BOOLEAN) && info(node.op).form == Form::infix &&
                        !info(node.op).has(flag::TAKES_WIDE);
  return compares ? values[node.operand[0]] - values[node.operand[1]] : values[condition];
}

} // namespace symreal
