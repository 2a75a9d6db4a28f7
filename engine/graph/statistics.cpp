#include "engine/graph/statistics.h"

namespace symreal {

Statistics statistics(Graph const &graph) {
  Statistics result;
  std::vector<char> const live = live_nodes(graph), recomputed = recomputed_nodes(graph);
  std::vector<char> before(graph.nodes.size(), 0); // per node: whether a value that preprocess stores needs it
  for (NodeId id : graph.precomputed) before[id] = 1;
  mark_operands(graph, before);
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

OperationCounts live_operations(Graph const &graph) {
  OperationCounts counts;
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id]) ++counts[graph.nodes[id].op];
  return counts;
}

std::vector<std::size_t> operations_by_location(Graph const &graph, bool live_only) {
  std::vector<std::size_t> counts(graph.locations.size(), 0);
  std::vector<char> const live = live_only ? live_nodes(graph) : std::vector<char>();
  for (std::size_t id = 0; id < graph.node_location.size(); ++id)
    if (LocationId const location = graph.node_location[id];
        location != no_location && !is_leaf(graph.nodes[id].op) && (!live_only || live[id]))
      ++counts[location];
  return counts;
}

} // namespace symreal
