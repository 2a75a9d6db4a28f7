// Scheduling network: a task graph with edges in both directions, reversible in time. A timetable of the reversed
// network is one of the network read from its end, so each method serves in both directions.
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

// Visits the tasks in topological order.
template <class Visit> void for_each_in_order(Network const &network, Visit visit) {
  auto const count = static_cast<TaskId>(network.size());
  for (TaskId i = 0; i < count; ++i) visit(network.is_reversed ? count - 1 - i : i);
}

// Per task, the longest path to its begin: its start with unlimited units.
std::vector<Time> longest_paths(Network const &network);

} // namespace symreal
