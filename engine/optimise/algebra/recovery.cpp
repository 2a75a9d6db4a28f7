#include "engine/optimise/algebra/recovery.h"

#include "engine/optimise/algebra/angle_sums.h"
#include "engine/optimise/algebra/base_parameters.h"
#include "engine/optimise/algebra/graph_network.h"
#include "engine/optimise/algebra/search.h"

#include <fmt/format.h>
#include <utility>

namespace symreal::algebra {

namespace {

constexpr std::uint64_t largest_searched = 1'000'000;

void tell_not_searched(Graph const &graph, std::string const &why, Report const &tell) {
  if (tell) tell({DiagnosticId::graph_not_searched, {}, fmt::format("kernel '{}' has {}", graph.kernel, why)});
}

// Start of the search: the network after all single-step rewrites.
Network start_of(Graph const &graph, CostModel const &costs, Report const &tell) {
  Network const related = with_calls_of_angle_sums(with_angle_sums(rebuilt(network_of(graph, costs)), costs), costs);
  Network network = rebuilt(with_common_reciprocals(rebuilt(related)));
  std::size_t too_many = 0;
  std::optional<Network> const base = with_base_parameters(network, &too_many);
  if (too_many != 0)
    tell_not_searched(graph,
                      fmt::format("{} parameters and products of them in {} operations: too many for base parameters "
                                  "to be looked for",
                                  too_many, cost_of(network)),
                      tell);
  if (base && cost_of(*base) < cost_of(network)) return rebuilt(*base);
  return network;
}

} // namespace

double cost_of(Graph const &graph, CostModel const &costs) {
  std::vector<char> const live = symreal::live_nodes(graph);
  double sum = 0;
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (live[id] && !is_leaf(node.op) && node.attribute == Attribute::variable) sum += costs[node.op];
  }
  return sum;
}

Graph recover_structure(Graph const &graph, int effort, CostModel const &costs, Report const &tell, bool searches) {
  if (effort == 0) return graph;
  Network network = start_of(graph, costs, tell);
  if (std::size_t const cost = cost_of(network); searches && cost <= largest_searched)
    network = searched(network, effort).network;
  else if (searches)
    tell_not_searched(
        graph,
        fmt::format("{} operations once equal ones are one, and --effort={} searches {} at most: only what "
                    "one step finds, such as equal expressions, was looked for",
                    cost, effort, largest_searched),
        tell);
  std::optional<Graph> result = graph_of(rebuilt(network), graph);
  if (!result || cost_of(*result, costs) >= cost_of(graph, costs)) return graph;
  return std::move(*result);
}

} // namespace symreal::algebra
