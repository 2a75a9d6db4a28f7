// An evaluation shared out to threads: who computes what in which stage, and how long that takes by measured costs.
//
//   statements ──▶ slices of time ──▶ in each, a share for every thread, or all for one
//
// A stage ends where all threads wait for each other; what a share needs of another comes from an earlier stage.
#pragma once

#include "engine/analysis/sharing/statements.h"
#include "engine/plan/schedule/parts.h"

namespace symreal {

// Estimates in nanoseconds. They leave out what loads, stores and full caches cost, on one thread and on several.
struct Sharing {
  unsigned threads = 1;
  std::vector<Share> shares = {}; // per statement of compute
  std::size_t stages = 0;         // that threads share
  std::size_t crossing = 0;       // values that one of them computes and another one may read
  double one_thread = 0;          // the larger of work and longest path
  double computing = 0;           // the slowest share of each stage
  double meeting = 0;             // to begin and to end these stages
  double moving = 0;              // of the values, eight at once

  double together() const { return computing + meeting + moving; }
  bool pays() const { return stages != 0 && together() < one_thread; }
};

// For costs that know what a region of sections takes.
Sharing share_out(Schedule const &plan, StatementTasks const &statements, Costs const &costs, unsigned threads);

} // namespace symreal
