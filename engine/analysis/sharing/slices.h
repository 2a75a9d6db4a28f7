// Slicing of statements: within a slice of time, unconnected statements go to different threads.
#pragma once

#include "engine/analysis/sharing/statements.h"
#include "engine/plan/schedule/parts.h"

namespace symreal {

// Finds cut points by dynamic programming over a topological order; `meeting` is the overhead of a shared slice. A
// slice that does not pay for it runs on one thread; consecutive slices of this kind merge.
std::vector<Share> sliced(StatementTasks const &statements, std::vector<TaskId> const &order, unsigned threads,
                          Time meeting);

} // namespace symreal
