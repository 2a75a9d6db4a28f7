// The statements of function `compute` as tasks: what its threads share out.
#pragma once

#include "engine/analysis/costs/costs.h"
#include "engine/plan/schedule/schedule.h"

namespace symreal {

// Durations are hundredths of the costs' unit. A statement lasts as long as its operations occupy a core; its latency
// is that of its longest path.
struct StatementTasks {
  static constexpr Time scale = 100;

  TaskGraph tasks;
  std::vector<Time> latency;
  std::vector<char> is_result; // an output is read from it when all is done
};
StatementTasks statement_tasks(Schedule const &plan, Costs const &costs);

} // namespace symreal
