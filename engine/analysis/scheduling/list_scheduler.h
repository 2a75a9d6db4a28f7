// List schedulers: the most urgent task comes next. They differ in whether time advances or gaps are filled, and in
// whether each task has a choice of unit.
#pragma once

#include "engine/analysis/scheduling/network.h"
#include "engine/analysis/scheduling/timetable.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace symreal {

// Topological order by priority: of the tasks whose predecessors have been visited, the one of greatest priority, then
// of smallest id, comes next. Reuses its memory among runs.
class PriorityOrder {
public:
  template <class Visit> void for_each(Network const &network, std::span<Time const> priority, Visit const &visit) {
    waits_for_.resize(network.size());
    for (TaskId task = 0; task < network.size(); ++task) {
      waits_for_[task] = static_cast<std::uint32_t>(network.before.of(task).size());
      if (waits_for_[task] == 0) ready_.push_back({priority[task], ~task});
    }
    std::ranges::make_heap(ready_);
    while (!ready_.empty()) {
      std::ranges::pop_heap(ready_);
      TaskId const task = ~ready_.back().second;
      ready_.pop_back();
      visit(task);
      for (TaskId after : network.after.of(task))
        if (--waits_for_[after] == 0) {
          ready_.push_back({priority[after], ~after});
          std::ranges::push_heap(ready_);
        }
    }
  }

private:
  std::vector<std::uint32_t> waits_for_;
  std::vector<std::pair<Time, TaskId>> ready_; // max-heap of priority and complement of id
};

// List scheduling: time advances; whenever a unit is free and a task of its kind is ready, the most urgent such task
// begins. A unit idles only if it has no ready task (R. L. Graham, 1966).
class ListScheduler {
public:
  ListScheduler(Network const &network, Units const &units) : network_(network), units_(units) {}

  // Tasks of greater priority, then of smaller id, are more urgent. Returns the length.
  Time run(std::span<Time const> priority, std::vector<Time> &start);

private:
  struct Urgent {
    Time priority;
    TaskId task;
    bool operator<(Urgent const &other) const {
      return priority != other.priority ? priority < other.priority : task > other.task;
    }
  };
  struct End {
    Time at;
    TaskId task;
    auto operator<=>(End const &) const = default;
  };
  void make_ready(TaskId task);
  void end_task(TaskId task);

  Network const &network_;
  Units const &units_;
  std::span<Time const> priority_;
  Time now_ = 0;
  std::vector<Time> *start_ = nullptr;
  std::vector<std::uint32_t> waits_for_;           // per task: predecessors that have not ended
  std::vector<std::priority_queue<Urgent>> ready_; // per kind
  std::vector<TaskId> instant_;                    // ready tasks of zero duration
  std::priority_queue<End, std::vector<End>, std::greater<>> running_;
};

// Number of busy units of one kind over time.
class Profile {
public:
  void clear() { steps_.assign(1, {0, 0}); }
  // Reserves a unit for `duration` at the earliest begin from `earliest` on; returns the begin.
  Time place(Time earliest, Time duration, unsigned units);

private:
  struct Occupancy {
    Time at; // until the next step
    unsigned busy;
  };
  std::size_t step_at(Time at); // the step that begins at `at`; made if absent
  std::vector<Occupancy> steps_;
};

// Insertion scheduling: takes the most urgent task among those whose predecessors are placed, and places it in the
// earliest gap that fits, between placed tasks. Every timetable in which no task can move to an earlier time results
// from some order; a shortest one is among them (J. E. Kelley, 1963).
class InsertionScheduler {
public:
  InsertionScheduler(Network const &network, Units const &units)
      : network_(network),
        units_(units),
        busy_(units.count.size()) {}

  // Tasks of greater priority, then of smaller id, are more urgent. Returns the length.
  Time run(std::span<Time const> priority, std::vector<Time> &start);

private:
  Network const &network_;
  Units const &units_;
  std::vector<Profile> busy_; // per kind
  PriorityOrder order_;
};

// List scheduling with a choice of unit for each task, given communication delays.
class UnitChooser {
public:
  UnitChooser(Network const &network, Units const &units, std::vector<char> const &is_dummy)
      : network_(network),
        units_(units),
        is_dummy_(is_dummy),
        busy_(units.total()),
        data_(units.total()) {}

  // Takes the most urgent task among those whose predecessors are placed, and places it in the earliest gap of its unit
  // in `fixed`, or without `fixed` on the unit where it ends first. Returns the length.
  Time run(std::span<Time const> priority, std::vector<std::uint32_t> const *fixed, Timetable &result);

private:
  struct Busy {
    Time from, until;
  };
  struct Gap {
    Time begin;
    std::size_t before; // index into the unit's busy times
  };
  void find_data(TaskId task, Timetable const &result);
  Gap earliest_gap(std::uint32_t unit, TaskId task) const;
  void place(TaskId task, std::vector<std::uint32_t> const *fixed, Timetable &result);

  Network const &network_;
  Units const &units_;
  std::vector<char> const &is_dummy_;
  std::vector<std::vector<Busy>> busy_; // per unit, ascending
  std::vector<Time> data_;              // per unit: arrival of the task's operands
  PriorityOrder order_;
};

} // namespace symreal
