// Sharing of one evaluation among threads: the thread and stage of each statement, and the time by measured costs.
//
//   statements ──▶ slices of time ──▶ in each, a share per thread, or one thread for all
//
// A stage ends with a barrier; values from another share come from an earlier stage.
#pragma once

#include "engine/analysis/costs/costs.h"
#include "engine/plan/schedule/schedule.h"

namespace symreal {

// Statements of function `compute` as tasks. Durations are hundredths of the costs' unit. A statement's duration is the
// throughput of its operations; its latency is that of its longest path.
struct StatementTasks {
  static constexpr Time scale = 100;

  TaskGraph tasks;
  std::vector<Time> latency;
  std::vector<char> is_result; // an output or check reads it at the end
};
StatementTasks statement_tasks(Plan const &plan, Costs const &costs);

// Slicing of statements: within a slice of time, unconnected statements go to different threads. Finds cut points by
// dynamic programming over a topological order; `meeting` is the overhead of a shared slice. A slice that does not pay
// for it runs on one thread; consecutive slices of this kind merge.
std::vector<Share> sliced(StatementTasks const &statements, std::vector<TaskId> const &order, unsigned threads,
                          Time meeting);

// Estimates in nanoseconds. They exclude loads, stores and cache misses, on one thread and on several.
struct Sharing {
  unsigned threads = 1;
  std::vector<Share> shares = {}; // per statement of `compute`
  std::size_t stages = 0;         // stages that several threads execute
  std::size_t crossing = 0;       // values that cross between threads
  double one_thread = 0;          // time on one thread: the larger of work and longest path
  double computing = 0;           // sum of the slowest share of each stage
  double meeting = 0;             // cost of beginning and ending these stages
  double moving = 0;              // cost of moving the values, eight at once

  double together() const { return computing + meeting + moving; }
  bool pays() const { return stages != 0 && together() < one_thread; }
};

// `costs` must have the cost of a region of sections.
Sharing share_out(Plan const &plan, StatementTasks const &statements, Costs const &costs, unsigned threads);

} // namespace symreal
