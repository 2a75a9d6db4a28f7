#include "algebra/recovery.h"

#include "algebra/graph_network.h"
#include "algebra/factoring.h"
#include <cstdio>

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
  std::mt19937_64 random(1);
  std::uint64_t work = 0;
  static constexpr int schedule[][2]={{0,3},{5,3},{2,3},{3,6},{1,8},{1,2},{2,8},{0,2},{1,1},{2,4},{0,6},{3,3}};
  int uses[]={8,4,2,3};
  std::size_t best = algebra::operation_count(network);
  fprintf(stderr, "A %zu\n", best);
  for (int i = 0; i < effort * 12; ++i) {
    auto const*s = schedule[i % 12];
    Network next = rebuilt(factored(network, {{s[0], s[1], uses[random() % 4], 30}, (double)(random()%2)*.15, (random()&1)!=0}, random, work));
    std::size_t count = algebra::operation_count(next);
    if (count <= best) { best = count; network = std::move(next); }
    fprintf(stderr, "%zu ", count);
  }
  fprintf(stderr, "work %zu\n", work);
  std::optional<Graph> result = graph_of(network, graph);
  if (!result || operation_count(*result) >= operation_count(graph)) return graph;
  return std::move(*result);
}

} // namespace symreal::algebra
