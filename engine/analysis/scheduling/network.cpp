#include "engine/analysis/scheduling/network.h"

#include <algorithm>
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

} // namespace symreal
