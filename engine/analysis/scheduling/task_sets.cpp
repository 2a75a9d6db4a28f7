#include "engine/analysis/scheduling/task_sets.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace symreal {
namespace {

// Records dominance between two tasks of one kind if all successors of b are successors of a.
void compare(TaskSets &sets, Network const &network, std::vector<TaskSet> const &after, TaskId a, TaskId b) {
  if (a == b || network.kind[a] != network.kind[b]) return;
  bool const covers = (after[a] & after[b]) == after[b];
  if (!covers) return;
  if (network.duration[a] == network.duration[b] && (after[a] != after[b] || a < b)) sets.first[b] |= set_of(a);
  if (network.duration[a] > network.duration[b]) sets.longer[b] |= set_of(a);
}

} // namespace

TaskSets task_sets(Network const &network, std::vector<Time> const &tail) {
  std::size_t const count = network.size();
  TaskSets sets{count == 0 ? 0 : ~TaskSet{0} >> (64 - count), 0, {}, {}, {}, std::vector<TaskId>(count), {}};
  std::vector<TaskSet> after(count);
  sets.before.resize(count);
  sets.first.resize(count);
  sets.longer.resize(count);
  for (TaskId task = 0; task < count; ++task) {
    if (network.duration[task] == 0) sets.instants |= set_of(task);
    for (TaskId other : network.after.of(task)) after[task] |= set_of(other);
    for (TaskId other : network.before.of(task)) sets.before[task] |= set_of(other);
  }
  for (TaskId a = 0; a < count; ++a)
    for (TaskId b = 0; b < count; ++b) compare(sets, network, after, a, b);
  std::iota(sets.by_tail.begin(), sets.by_tail.end(), TaskId{0});
  sets.by_urgency = sets.by_tail;
  std::ranges::sort(sets.by_tail, {}, [&](TaskId task) { return std::pair(-tail[task], task); });
  std::ranges::sort(sets.by_urgency, {}, [&](TaskId task) {
    return std::tuple(-tail[task] - network.duration[task], -std::popcount(after[task]), task);
  });
  return sets;
}

} // namespace symreal
