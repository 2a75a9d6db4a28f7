// Up to 64 tasks as the bits of a word, and what an exact search knows of them from the beginning.
#pragma once

#include "engine/analysis/scheduling/network.h"

#include <bit>

namespace symreal {

using TaskSet = std::uint64_t;
inline TaskSet set_of(TaskId task) { return TaskSet{1} << task; }

template <class Visit> void for_each(TaskSet set, Visit visit) {
  for (; set != 0; set &= set - 1) visit(static_cast<TaskId>(std::countr_zero(set)));
}

struct TaskSets {
  TaskSet all, instants;          // instants take no time
  std::vector<TaskSet> before;    // per task: its predecessors
  std::vector<TaskSet> first;     // those that must not be ready and unstarted when it begins
  std::vector<TaskSet> longer;    // those that could change places with it, if ready when it begins
  std::vector<TaskId> by_tail;    // the longest first
  std::vector<TaskId> by_urgency; // the order in which the search decides; those in `first` come before
};

TaskSets task_sets(Network const &network, std::vector<Time> const &tail);

} // namespace symreal
