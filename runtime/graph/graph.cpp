#include "graph/graph.h"

namespace symreal {

Graph without_nodes(Graph const &graph) {
  Graph rest;
  rest.kernel = graph.kernel;
  rest.inputs = graph.inputs;
  rest.parameters = graph.parameters;
  rest.outputs = graph.outputs;
  rest.input_values = graph.input_values;
  rest.parameter_values = graph.parameter_values;
  rest.frozen = graph.frozen;
  rest.executed = graph.executed;
  return rest;
}

void move_roots(Graph const &graph, std::vector<NodeId> const &now, Graph &result) {
  for (NodeId root : graph.results) result.results.push_back(now[root]);
  for (NodeId root : graph.precomputed) result.precomputed.push_back(now[root]);
}

std::vector<char> live_nodes(Graph const &graph) {
  std::vector<char> live(graph.nodes.size(), 0);
  for (NodeId result : graph.results) live[result] = 1;
  for (NodeId stored : graph.precomputed) live[stored] = 1;
  // Operands are older than users, so one sweep from the newest node down meets every user before its operands.
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!live[id] || is_leaf(node.op)) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node) live[operand] = 1;
  }
  return live;
}

} // namespace symreal
