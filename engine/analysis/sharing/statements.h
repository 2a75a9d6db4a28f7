// Statement tasks: the statements of function `compute` as tasks, which its threads share.
#pragma once

#include "engine/analysis/costs/costs.h"
#include "engine/plan/schedule/schedule.h"

namespace symreal {

// Durations are hundredths of the costs' unit. A statement's duration is the throughput of its operations; its latency
// is that of its longest path.
struct StatementTasks {
  static constexpr Time scale = 100;

  TaskGraph tasks;
  std::vector<Time> latency;
  std::vector<char> is_result; // an output or check reads it at the end
};
StatementTasks statement_tasks(Schedule const &plan, Costs const &costs);

} // namespace symreal
