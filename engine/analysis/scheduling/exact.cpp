#include "engine/analysis/scheduling/exact.h"

#include "engine/analysis/scheduling/search_states.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace symreal {

namespace {

// Static data of the search.
struct TaskSets {
  TaskSet all, instants;          // instants have zero duration
  std::vector<TaskSet> before;    // per task: its predecessors
  std::vector<TaskSet> first;     // tasks that must not be ready and unstarted when it begins
  std::vector<TaskSet> longer;    // tasks that could change places with it if ready when it begins
  std::vector<TaskId> by_tail;    // descending by tail
  std::vector<TaskId> by_urgency; // branching order; tasks in `first` precede
};

// Records dominance between two tasks of one kind if all successors of b are successors of a.
void compare(TaskSets &sets, Network const &network, std::vector<TaskSet> const &after, TaskId a, TaskId b) {
  if (a == b || network.kind[a] != network.kind[b] || (after[a] & after[b]) != after[b]) return;
  if (network.duration[a] == network.duration[b] && (after[a] != after[b] || a < b)) sets.first[b] |= set_of(a);
  if (network.duration[a] > network.duration[b]) sets.longer[b] |= set_of(a);
}

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

class StartTimeSearch {
public:
  StartTimeSearch(Network const &network, Units const &units, Windows const &windows, Time below, Time enough,
                  std::uint64_t most_nodes)
      : network_(network),
        units_(units),
        tail_(windows.tail),
        best_(below),
        enough_(enough),
        most_nodes_(most_nodes),
        sets_(task_sets(network, windows.tail)),
        free_(units.count),
        seen_(std::min<std::size_t>(network.size() + 4, most_nodes < 1'000'000 ? 16 : 20)),
        start_(network.size()),
        head_(network.size()),
        could_change_(network.size()) {}

  ExactResult run() {
    enter(0, 0, 0);
    return {best_start_, !is_over_limit_, nodes_};
  }

private:
  bool is_over() const { return is_over_limit_ || best_ <= enough_; }

  // Visits a time at which a task has ended. Tasks in `held_back` could have begun before and may not begin now.
  void enter(Time now, TaskSet ended, TaskSet held_back) {
    for (TaskSet instant = 1; instant != 0;) {
      instant = ready(ended) & sets_.instants;
      for_each(instant, [&](TaskId task) { start_[task] = now; });
      ended |= instant;
    }
    TaskSet const started_before = started_;
    started_ |= ended;
    if (ended == sets_.all) {
      if (now < best_) best_start_ = start_, best_ = now;
    } else if (++nodes_ > most_nodes_) {
      is_over_limit_ = true;
    } else if (!is_hopeless(now, ended) && !seen_.was_seen(key(now, ended, held_back), now)) {
      begin_some(now, ended, held_back, 0);
    }
    started_ = started_before;
  }

  TaskSet ready(TaskSet ended) const {
    TaskSet result = 0;
    for_each(sets_.all & ~ended, [&](TaskId task) {
      if ((sets_.before[task] & ~ended) == 0) result |= set_of(task);
    });
    return result;
  }

  StateKey key(Time now, TaskSet ended, TaskSet held_back) const {
    StateKey result;
    result.add(ended);
    result.add(held_back);
    for_each(started_ & ~ended, [&](TaskId task) {
      result.add(task);
      result.add(static_cast<std::uint64_t>(end_of(task) - now));
      result.add(could_change_[task] & ~started_);
    });
    return result;
  }

  // Branches over the ready tasks from position `from` of the urgency order on, then advances time.
  void begin_some(Time now, TaskSet ended, TaskSet held_back, std::size_t from) {
    if (is_over()) return;
    TaskSet const can_begin = ready(ended) & ~started_;
    for (std::size_t i = from; i < sets_.by_urgency.size(); ++i) {
      TaskId const task = sets_.by_urgency[i];
      if (!(can_begin & ~held_back & set_of(task)) || free_[network_.kind[task]] == 0 ||
          (sets_.first[task] & can_begin))
        continue;
      start_[task] = now;
      could_change_[task] = sets_.longer[task] & can_begin;
      started_ |= set_of(task);
      --free_[network_.kind[task]];
      begin_some(now, ended, held_back, i + 1);
      ++free_[network_.kind[task]];
      started_ &= ~set_of(task);
      if (is_over()) return;
    }
    go_on(ended, can_begin);
  }

  void go_on(TaskSet ended, TaskSet can_begin) {
    TaskSet const running = started_ & ~ended;
    if (running == 0) return;
    Time next = end_of(static_cast<TaskId>(std::countr_zero(running)));
    for_each(running, [&](TaskId task) { next = std::min(next, end_of(task)); });
    if (next >= best_) return;
    TaskSet held_back = 0, ending = 0;
    for_each(can_begin & ~started_, [&](TaskId task) {
      if (free_[network_.kind[task]] != 0) held_back |= set_of(task);
    });
    for_each(running, [&](TaskId task) {
      if (end_of(task) == next) ending |= set_of(task);
    });
    for_each(ending, [&](TaskId task) { ++free_[network_.kind[task]]; });
    for_each(ending, [&](TaskId task) { held_back |= could_change_[task] & ~started_; });
    enter(next, ended | ending, held_back);
    for_each(ending, [&](TaskId task) { --free_[network_.kind[task]]; });
  }

  // Whether an interval's work exceeds its capacity in any timetable shorter than the best.
  bool is_hopeless(Time now, TaskSet ended) {
    std::array<Time, most_exact_tasks> begins;
    std::size_t count = 0;
    for (TaskId task = 0; task < network_.size(); ++task) {
      if (ended & set_of(task)) continue;
      head_[task] = now; // of a running task: includes its remainder
      if (!(started_ & set_of(task))) {
        for_each(sets_.before[task] & ~ended,
                 [&](TaskId other) { head_[task] = std::max(head_[task], head_end(other)); });
      }
      if (head_end(task) + tail_[task] >= best_) return true;
      begins[count++] = head_[task];
    }
    std::sort(begins.begin(), begins.begin() + count);
    count = static_cast<std::size_t>(std::unique(begins.begin(), begins.begin() + count) - begins.begin());
    for (std::size_t i = 0; i < count; ++i)
      if (is_too_much(begins[i], ended)) return true;
    return false;
  }

  bool is_too_much(Time begin, TaskSet ended) {
    work_.assign(units_.count.size(), 0);
    for (TaskId task : sets_.by_tail) {
      if (ended & set_of(task)) continue;
      Time const within = head_end(task) - std::max(begin, head_[task]);
      if (within <= 0) continue;
      std::size_t const kind = network_.kind[task];
      work_[kind] += within;
      if (work_[kind] > static_cast<Time>(units_.count[kind]) * (best_ - 1 - begin - tail_[task])) return true;
    }
    return false;
  }

  Time end_of(TaskId task) const { return start_[task] + network_.duration[task]; }
  Time head_end(TaskId task) const {
    return started_ & set_of(task) ? end_of(task) : head_[task] + network_.duration[task];
  }

  Network const &network_;
  Units const &units_;
  std::vector<Time> const &tail_;
  Time best_, enough_;
  std::uint64_t most_nodes_, nodes_ = 0;
  bool is_over_limit_ = false;
  TaskSets const sets_;
  TaskSet started_ = 0;
  std::vector<unsigned> free_; // free units per kind
  SeenStates seen_;
  std::vector<Time> start_, head_, best_start_, work_;
  std::vector<TaskSet> could_change_; // per running task: longer tasks that were ready when it began
};

} // namespace

ExactResult search_exactly(Network const &network, Units const &units, Windows const &windows, Time below, Time enough,
                           std::uint64_t most_nodes) {
  return StartTimeSearch(network, units, windows, below, enough, most_nodes).run();
}

} // namespace symreal
