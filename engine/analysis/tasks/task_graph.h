// Tasks with durations, and which must end before which begins: a weighted directed acyclic graph in compressed rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace symreal {

using TaskId = std::uint32_t;
using Time =
    std::int64_t; // in the unit of whoever made the graph: operations, weights of a table, tenths of a nanosecond

// How long so much work takes at least if it is shared evenly.
inline Time shared(Time work, Time units) { return (work + units - 1) / units; }

struct TaskGraph {
  std::vector<Time> duration;                         // per task; a topological order: predecessors are older
  std::vector<std::uint32_t> first_predecessor = {0}; // per task, and the end
  std::vector<TaskId> predecessor;                    // of each task in ascending order, none twice
  std::vector<std::uint8_t> kind;                     // per task, of unit that it needs; empty: one kind for all

  std::size_t size() const { return duration.size(); }
  std::span<TaskId const> predecessors(TaskId task) const {
    return {predecessor.data() + first_predecessor[task], predecessor.data() + first_predecessor[task + 1]};
  }
  // The next task; `before` may name a task twice.
  void add(Time duration_of_task, std::span<TaskId const> before);
};

// The same rows by predecessor.
struct Successors {
  std::vector<std::uint32_t> first;
  std::vector<TaskId> successor; // of each task in ascending order

  std::span<TaskId const> of(TaskId task) const {
    return {successor.data() + first[task], successor.data() + first[task + 1]};
  }
};
Successors successors(TaskGraph const &graph);

} // namespace symreal
