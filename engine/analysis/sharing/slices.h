// Statements in slices of time. In a slice, those that have nothing to do with each other go to different threads.
#pragma once

#include "engine/analysis/sharing/statements.h"
#include "engine/plan/schedule/parts.h"

namespace symreal {

// Where to cut is found by dynamic programming over an order in which nothing stands before what it needs; `meeting`:
// what a slice costs that threads share. Where that is not worth it one thread computes; slices of this kind that
// follow each other are one.
std::vector<Share> sliced(StatementTasks const &statements, std::vector<TaskId> const &order, unsigned threads,
                          Time meeting);

} // namespace symreal
