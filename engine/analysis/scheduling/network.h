// Scheduling network: a task graph with edges in both directions, reversible in time. A timetable of the reversed
// network is one of the network read from its end, so each method serves in both directions.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

#include <bit>

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

inline constexpr std::size_t most_tasks_with_ancestors = 8192; // 8 MiB
// Ancestor sets of tasks as bit rows. Quadratic in the number of tasks, hence the limit.
class Ancestors {
public:
  explicit Ancestors(Network const &network) : words_((network.size() + 63) / 64), bits_(words_ * network.size()) {
    for_each_in_order(network, [&](TaskId task) {
      for (TaskId before : network.before.of(task)) {
        for (std::size_t i = 0; i < words_; ++i) bits_[task * words_ + i] |= bits_[before * words_ + i];
        bits_[task * words_ + before / 64] |= std::uint64_t{1} << before % 64;
      }
    });
  }

  bool has(TaskId task, TaskId other) const { return bits_[task * words_ + other / 64] >> other % 64 & 1; }
  std::size_t count(TaskId task) const {
    std::size_t result = 0;
    for (std::size_t i = 0; i < words_; ++i)
      result += static_cast<std::size_t>(std::popcount(bits_[task * words_ + i]));
    return result;
  }

private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

// Decomposition of a graph into a chain of parts: all tasks of a part must end before any of the next begins. So parts
// can be scheduled separately, and their shortest timetables concatenate to one of the graph. Yields the tasks of each
// part, ascending. A single part for very many tasks.
std::vector<std::vector<TaskId>> chain_of_parts(Network const &network);

// Subgraph of a part, with its internal dependencies. Ids are indices into `part`.
TaskGraph part_graph(TaskGraph const &graph, std::vector<TaskId> const &part);

} // namespace symreal
