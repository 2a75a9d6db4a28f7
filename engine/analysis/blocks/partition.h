// Partition of a task graph into blocks of similar work with few crossing values.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

#include <optional>

namespace symreal {

// Connected components of a task graph, regardless of edge direction. Operations that share only inputs or constants,
// which are not tasks, are not connected. Linear time.
struct Components {
  std::vector<std::uint32_t> of_task; // numbered in order of their first tasks
  std::vector<std::size_t> tasks;     // per component: tasks of nonzero duration
  std::vector<Time> work;             // per component: total duration

  // Number of components with a task of nonzero duration.
  std::size_t count() const;
  std::size_t largest() const;
};
Components components(TaskGraph const &graph);

using BlockId = std::uint32_t;

struct Blocks {
  std::uint32_t count = 0;
  std::vector<BlockId> of_task; // numbered in order of their first tasks

  BlockId operator[](TaskId task) const { return of_task[task]; }
};

// Distributes whole components if that is balanced. Else METIS cuts the graph (G. Karypis and V. Kumar, 1998), ignoring
// edge directions. Work is the tasks' durations. Each block gets a task of nonzero duration; `count` is at least 1 and
// at most the number of these. Deterministic. Throws bad_option if METIS fails.
Blocks partition(TaskGraph const &graph, Components const &components, std::uint32_t count);

// Figures of a partition into blocks: its balance, and the values that cross between blocks.
struct BlockFigures {
  std::vector<std::size_t> operations; // per block: tasks of nonzero duration
  std::vector<Time> work;              // per block
  double balance = 1;                  // the largest work relative to the mean
  std::size_t cut = 0;                 // dependencies between tasks of two blocks
  std::size_t volume = 0;              // values that cross, counted once per receiving block
  std::size_t hand_overs = 0;          // the most on any path
  std::optional<std::size_t> depth;    // longest chain of blocks; nullopt for a cycle
};
BlockFigures block_figures(TaskGraph const &graph, Blocks const &blocks);

// Length of the longest path if each step to another block takes `hand_over`.
Time span_of_blocks(TaskGraph const &graph, Blocks const &blocks, Time hand_over);

// Length of the schedule in which each block executes its tasks in the order of the graph.
Time length_in_order(TaskGraph const &graph, Blocks const &blocks, Time hand_over);

} // namespace symreal
