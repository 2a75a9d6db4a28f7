// The shortest length by trying everything, as plainly as possible: what the scheduler is compared with.
#pragma once

#include "engine/analysis/scheduling/timetable.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace symreal {

// Without communication. Time goes on by one; each time any set of ready tasks may begin.
class EveryStep {
public:
  EveryStep(TaskGraph const &graph, Units const &units) : graph_(graph), units_(units) {}

  Time shortest() {
    std::set<State> states = {State(graph_.size(), waiting)};
    for (Time now = 0;; ++now) {
      std::set<State> next;
      bool is_done = false;
      for (State const &state : states) begin_any(state, 0, next, is_done);
      if (is_done) return now;
      states = std::move(next);
    }
  }

private:
  using State = std::vector<int>; // per task: what is left of it
  static constexpr int waiting = -1;

  std::size_t kind(TaskId task) const { return graph_.kind.empty() ? 0 : graph_.kind[task]; }
  bool can_begin(State const &state, TaskId task) const {
    unsigned busy = 0;
    for (TaskId other = 0; other < graph_.size(); ++other) busy += state[other] > 0 && kind(other) == kind(task);
    auto const has_ended = [&](TaskId before) { return state[before] == 0; };
    return state[task] == waiting && (graph_.duration[task] == 0 || busy < units_.count[kind(task)]) &&
           std::ranges::all_of(graph_.predecessors(task), has_ended);
  }
  // Begins any of the tasks from `from` on, and lets one unit of time pass.
  void begin_any(State const &state, TaskId from, std::set<State> &next, bool &is_done) const {
    if (std::ranges::all_of(state, [](int left) { return left == 0; })) is_done = true;
    for (TaskId task = from; task < graph_.size(); ++task) {
      if (!can_begin(state, task)) continue;
      State with = state;
      with[task] = static_cast<int>(graph_.duration[task]);
      begin_any(with, task + 1, next, is_done);
      if (graph_.duration[task] == 0) return; // nothing speaks against it
    }
    State later = state;
    for (int &left : later) left -= left > 0;
    next.insert(std::move(later));
  }

  TaskGraph const &graph_;
  Units const &units_;
};

// With communication: every order of the tasks, every unit.
class EveryOrder {
public:
  EveryOrder(TaskGraph const &graph, Units const &units)
      : graph_(graph),
        units_(units),
        is_dummy_(dummies(graph)),
        unit_(graph.size(), none),
        end_(graph.size()),
        free_(units.total()) {}

  Time shortest() {
    go(0, 0);
    return best_;
  }

private:
  static constexpr std::uint32_t none = ~0u;

  void go(std::size_t placed, Time length) {
    if (length >= best_) return;
    if (placed == graph_.size()) best_ = length;
    for (TaskId task = 0; task < graph_.size(); ++task) {
      auto const is_placed = [&](TaskId other) { return unit_[other] != none; };
      if (is_placed(task) || !std::ranges::all_of(graph_.predecessors(task), is_placed)) continue;
      std::size_t const kind = graph_.kind.empty() ? 0 : graph_.kind[task];
      std::uint32_t const first = units_.first_of(kind);
      for (std::uint32_t i = 0; i < units_.count[kind]; ++i) place(task, first + i, placed, length);
    }
  }
  void place(TaskId task, std::uint32_t unit, std::size_t placed, Time length) {
    Time begin = graph_.duration[task] == 0 ? 0 : free_[unit];
    for (TaskId before : graph_.predecessors(task)) {
      bool const moved = unit_[before] != unit && !is_dummy_[before] && !is_dummy_[task];
      begin = std::max(begin, end_[before] + (moved ? units_.communication : 0));
    }
    Time const free = free_[unit];
    unit_[task] = unit;
    end_[task] = begin + graph_.duration[task];
    if (graph_.duration[task] != 0) free_[unit] = end_[task];
    go(placed + 1, std::max(length, end_[task]));
    unit_[task] = none;
    free_[unit] = free;
  }

  TaskGraph const &graph_;
  Units const &units_;
  std::vector<char> is_dummy_;
  std::vector<std::uint32_t> unit_; // per task
  std::vector<Time> end_, free_;    // per task, per unit
  Time best_ = std::numeric_limits<Time>::max();
};

} // namespace symreal
