#include "algebra/recovery.h"

#include "algebra/angle_sums.h"
#include "algebra/base_parameters.h"
#include "algebra/graph_network.h"
#include "algebra/reciprocals.h"
#include "algebra/windows.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace symreal::algebra {

namespace {

// Of work, not of time, so that a result depends on nothing else. A million are done in about an eighth of a second.
struct Budget {
  int starts;          // independent searches, the best of which goes on
  std::uint64_t first; // work for all of them
  std::uint64_t all;
  int disturbances; // after which nothing better was found
};

Budget budget_for(int effort, std::uint64_t cost) {
  constexpr std::uint64_t million = 1'000'000;
  if (effort == 1) return {1, million / 10 + 600 * cost, 0, 0};
  std::uint64_t const work = std::clamp(120 * million + 45'000 * cost, 300 * cost, 450 * million);
  int const starts = static_cast<int>(std::clamp<std::uint64_t>(12'000 / (cost + 1), 1, 8));
  if (effort == 2) return {starts, work / 2, work, 30};
  return {8, 4 * work, 10 * work, 300};
}

constexpr std::uint64_t largest_as_a_whole = 20'000, largest_searched = 1'000'000;

struct Found {
  Network network;
  std::size_t cost;
};

// Passes over windows until so much work is done. What gets no better for some passes is disturbed.
Found search_in_windows(Network start, Search &search, std::uint64_t end, int disturbances) {
  constexpr std::size_t lengths[] = {150, 300, 600, 1000};
  constexpr int patience = 5;
  std::size_t cost = cost_of(start);
  Found best = {start, cost};
  Network network = std::move(start);
  for (int idle = 0, disturbed_in_vain = 0; search.work < end;) {
    Network next = improved_in_windows(network, {.length = lengths[search.random() % 4]}, search);
    std::size_t const next_cost = cost_of(next);
    idle = next_cost < cost ? 0 : idle + 1;
    if (next_cost <= cost) network = std::move(next), cost = next_cost;
    if (cost < best.cost) {
      best = {network, cost};
      disturbed_in_vain = 0;
    }
    if (idle < patience) continue;
    if (disturbed_in_vain++ == disturbances) break;
    network = disturbed(best.network, search);
    cost = cost_of(network);
    idle = 0;
  }
  return best;
}

Network searched(Network const &network, int effort) {
  std::size_t const cost = cost_of(network);
  Budget const budget = budget_for(effort, cost);
  Found best = {network, cost};
  std::uint64_t work = 0;
  for (int start = 0; start < budget.starts; ++start) {
    Search search(static_cast<std::uint64_t>(start) + 1);
    Network whole = cost > largest_as_a_whole ? network : improved(network, 12, search);
    Found found = search_in_windows(std::move(whole), search, budget.first / budget.starts, 0);
    work += search.work;
    if (found.cost < best.cost) best = std::move(found);
  }
  Search search(0);
  search.work = work;
  return search_in_windows(std::move(best.network), search, budget.all, budget.disturbances).network;
}

void tell_not_searched(Graph const &graph, std::string const &why, Report const &tell) {
  if (tell) tell({DiagnosticId::graph_not_searched, {}, fmt::format("kernel '{}' has {}", graph.kernel, why)});
}

// Where the search begins.
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
    network = searched(network, effort);
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
