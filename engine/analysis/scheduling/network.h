// A task graph as the scheduler walks it: in both directions, and with time reversed. What is found for the reversed
// network holds for the network, read from its end: so each method has its mirror image for nothing.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

namespace symreal {

struct Network {
  std::vector<Time> duration;
  std::vector<std::uint8_t> kind; // per task
  Successors before, after;       // rows by task
  bool is_reversed = false;       // then ids descend from predecessors to successors

  std::size_t size() const { return duration.size(); }
};

Network make_network(TaskGraph const &graph);
Network reversed(Network const &network);

// The task ids from predecessors to successors.
template <class Visit> void for_each_in_order(Network const &network, Visit visit) {
  auto const count = static_cast<TaskId>(network.size());
  for (TaskId i = 0; i < count; ++i) visit(network.is_reversed ? count - 1 - i : i);
}

// Per task the longest path up to its beginning: when it begins if there are units for all.
std::vector<Time> longest_paths(Network const &network);

} // namespace symreal
