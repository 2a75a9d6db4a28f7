#include "passes/compact.h"

namespace symreal {

Graph compact(Graph const &graph, std::vector<char> const &keep) {
  Graph result = without_nodes(graph);
  std::vector<NodeId> now(graph.nodes.size(), no_node);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!keep[id]) continue;
    Node node = graph.nodes[id];
    if (!is_leaf(node.op))
      for (NodeId &operand : node.operand)
        if (operand != no_node) operand = now[operand];
    now[id] = static_cast<NodeId>(result.nodes.size());
    result.nodes.push_back(node);
  }
  carry_over(graph, now, result);
  return result;
}

} // namespace symreal
