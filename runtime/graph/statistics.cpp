#include "graph/statistics.h"

namespace symreal {

// What the values that `preprocess` stores need.
static std::vector<char> preprocess_nodes(Graph const &graph) {
  std::vector<char> needed(graph.nodes.size(), 0);
  for (NodeId id : graph.precomputed) needed[id] = 1;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!needed[id] || is_leaf(node.op)) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node) needed[operand] = 1;
  }
  return needed;
}

Statistics statistics(Graph const &graph) {
  Statistics result;
  std::vector<char> live = live_nodes(graph);
  std::vector<char> const recomputed = recomputed_nodes(graph), before = preprocess_nodes(graph);
  bool const split = !graph.precomputed.empty();
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    ++result.recorded[node.op];
    if (!live[id]) continue;
    bool const is_hoisted = split && node.attribute == Attribute::parametric;
    if (!is_hoisted || recomputed[id]) ++result.compute[node.op];
    if (is_hoisted && (!recomputed[id] || before[id])) ++result.preprocess[node.op];
  }
  return result;
}

} // namespace symreal
