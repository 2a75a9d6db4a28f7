#include "engine/analysis/scheduling/windows.h"

#include "engine/analysis/scheduling/ancestors.h"

#include <algorithm>

namespace symreal {
namespace {

std::vector<Time> heads(Network const &network, Units const &units) {
  if (network.size() > most_tasks_with_ancestors) return longest_paths(network);
  Ancestors const ancestors(network);
  std::vector<Time> head(network.size());
  std::vector<TaskId> done; // descending by head
  for_each_in_order(network, [&](TaskId task) {
    for (TaskId before : network.before.of(task))
      head[task] = std::max(head[task], head[before] + network.duration[before]);
    std::vector<Time> work(units.count.size()); // per kind: of ancestors with at least the current head
    for (TaskId other : done) {
      if (!ancestors.has(task, other)) continue;
      std::size_t const kind = network.kind[other];
      work[kind] += network.duration[other];
      head[task] = std::max(head[task], head[other] + shared(work[kind], units.count[kind]));
    }
    done.insert(std::ranges::upper_bound(done, head[task], std::greater<>(), [&](TaskId other) { return head[other]; }),
                task);
  });
  return head;
}

} // namespace

Windows windows(Network const &network, Units const &units) {
  return {heads(network, units), heads(reversed(network), units)};
}

} // namespace symreal
