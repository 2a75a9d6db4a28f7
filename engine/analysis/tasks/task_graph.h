// Task graph: a weighted directed acyclic graph in compressed sparse rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace symreal {

using TaskId = std::uint32_t;
using Time = std::int64_t; // in the graph's unit: operations, table weights or tenths of a nanosecond

// Time of `work` shared evenly by `units`, rounded up.
inline Time shared(Time work, Time units) { return (work + units - 1) / units; }

struct TaskGraph {
  std::vector<Time> duration;                         // per task, in topological order
  std::vector<std::uint32_t> first_predecessor = {0}; // per task, plus the end
  std::vector<TaskId> predecessor;                    // per task ascending, without duplicates
  std::vector<std::uint8_t> kind;                     // per task, of its unit; empty if there is only one kind

  std::size_t size() const { return duration.size(); }
  std::span<TaskId const> predecessors(TaskId task) const {
    return {predecessor.data() + first_predecessor[task], predecessor.data() + first_predecessor[task + 1]};
  }
  // Appends a task; `before` may contain duplicates.
  void add(Time duration_of_task, std::span<TaskId const> before);
};

// Rows of successors.
struct Successors {
  std::vector<std::uint32_t> first;
  std::vector<TaskId> successor; // per task ascending

  std::span<TaskId const> of(TaskId task) const {
    return {successor.data() + first[task], successor.data() + first[task + 1]};
  }
};
Successors successors(TaskGraph const &graph);

} // namespace symreal
