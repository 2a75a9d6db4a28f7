#include "algebra/recovery.h"

#include "algebra/graph_network.h"

namespace symreal::algebra {

namespace {

std::size_t operation_count(Graph const &graph) {
  std::vector<char> const live = symreal::live_nodes(graph);
  std::size_t count = 0;
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    Op const op = graph.nodes[id].op;
    bool const is_arithmetic = op == Op::add || op == Op::sub || op == Op::mul || op == Op::div;
    count += live[id] && is_arithmetic && graph.nodes[id].attribute == Attribute::variable;
  }
  return count;
}

} // namespace

Graph recover_structure(Graph const &graph, int effort) {
  if (effort == 0) return graph;
  Network network = rebuilt(network_of(graph));
  std::optional<Graph> result = graph_of(network, graph);
  if (!result || operation_count(*result) >= operation_count(graph)) return graph;
  return std::move(*result);
}

} // namespace symreal::algebra
