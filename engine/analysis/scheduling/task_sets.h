// Sets of up to 64 tasks as bits of a word, and the static data of an exact search.
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
  TaskSet all, instants;          // instants have zero duration
  std::vector<TaskSet> before;    // per task: its predecessors
  std::vector<TaskSet> first;     // tasks that must not be ready and unstarted when it begins
  std::vector<TaskSet> longer;    // tasks that could change places with it if ready when it begins
  std::vector<TaskId> by_tail;    // descending by tail
  std::vector<TaskId> by_urgency; // branching order; tasks in `first` precede
};

TaskSets task_sets(Network const &network, std::vector<Time> const &tail);

} // namespace symreal
