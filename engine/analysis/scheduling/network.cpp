#include "engine/analysis/scheduling/network.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace symreal {

Network make_network(TaskGraph const &graph) {
  Network result;
  result.duration = graph.duration;
  result.kind = graph.kind;
  result.kind.resize(graph.size());
  result.before = {graph.first_predecessor, graph.predecessor};
  result.after = successors(graph);
  return result;
}

Network reversed(Network const &network) {
  Network result = network;
  std::swap(result.before, result.after);
  result.is_reversed = !network.is_reversed;
  return result;
}

std::vector<Time> longest_paths(Network const &network) {
  std::vector<Time> start(network.size());
  for_each_in_order(network, [&](TaskId task) {
    for (TaskId before : network.before.of(task))
      start[task] = std::max(start[task], start[before] + network.duration[before]);
  });
  return start;
}

// With tasks sorted by ancestor count, those from position k on form a new part if each has at least k ancestors: the
// ancestors of the first of them have fewer, so they are the k tasks before it; and any ancestor of another is one of
// the k or comes after all k.
std::vector<std::vector<TaskId>> chain_of_parts(Network const &network) {
  std::vector<TaskId> order(network.size());
  std::iota(order.begin(), order.end(), TaskId{0});
  if (network.size() > most_tasks_with_ancestors) return {order};
  Ancestors const ancestors(network);
  std::vector<std::size_t> count(network.size());
  for (TaskId task : order) count[task] = ancestors.count(task);
  std::ranges::sort(order, {}, [&](TaskId task) { return std::pair(count[task], task); });
  std::vector<std::vector<TaskId>> result;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (count[order[k]] == k) result.emplace_back();
    result.back().push_back(order[k]);
  }
  for (std::vector<TaskId> &part : result) std::ranges::sort(part);
  return result;
}

TaskGraph part_graph(TaskGraph const &graph, std::vector<TaskId> const &part) {
  TaskGraph result;
  std::vector<TaskId> before;
  for (TaskId task : part) {
    before.clear();
    for (TaskId other : graph.predecessors(task)) {
      auto const place = std::ranges::lower_bound(part, other);
      if (place != part.end() && *place == other) before.push_back(static_cast<TaskId>(place - part.begin()));
    }
    result.add(graph.duration[task], before);
    if (!graph.kind.empty()) result.kind.push_back(graph.kind[task]);
  }
  return result;
}

} // namespace symreal
