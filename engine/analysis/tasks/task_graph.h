// Task graph: a weighted directed acyclic graph in compressed sparse rows, and that of the operations of a graph.
#pragma once

#include "engine/graph/graph.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace symreal {

using TaskId = std::uint32_t;
using Time = std::int64_t; // in the graph's unit: operations, table weights or tenths of a nanosecond

// Root of the task's set in a union-find forest. Halves the path to it.
TaskId root(std::vector<TaskId> &parent, TaskId task);

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

// End of the last task.
Time length(TaskGraph const &graph, std::vector<Time> const &start);

// Cost of each operation, indexed by Op. Leaves cost 0.
using OperationCosts = std::array<Time, static_cast<std::size_t>(Op::count)>;

// 1 for each operation, 0 for those that are free in the cost table: changes of sign, argument lists.
OperationCosts unit_costs();
// Column `cost` of the operation table.
OperationCosts table_costs();

// Operations of function `compute`: the live operations that depend on an input or that it recomputes, or all live ones
// if the graph has no `preprocess`. Stored values, constants, inputs and parameters exist from the start.
struct OperationTasks {
  TaskGraph tasks;
  std::vector<NodeId> node; // per task, ascending
};
OperationTasks operation_tasks(Graph const &graph, OperationCosts const &costs);

} // namespace symreal
