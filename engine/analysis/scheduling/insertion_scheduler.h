// Insertion: the tasks are taken one by one, the most urgent among those whose predecessors are placed, and each goes
// to the earliest gap that takes it, between tasks that are placed already. Every timetable that no task could leave
// for an earlier time comes from some order; among them is a shortest one (J. E. Kelley, 1963).
#pragma once

#include "engine/analysis/scheduling/priority_order.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

// How many units of one kind are busy when.
class Profile {
public:
  void clear() { steps_.assign(1, {0, 0}); }
  // The earliest beginning, not before `earliest`, of a time in which one of the units is free; it is busy then.
  Time place(Time earliest, Time duration, unsigned units);

private:
  struct Step {
    Time at; // until the next step
    unsigned busy;
  };
  std::size_t step_at(Time at); // a step that begins there, which is made if there is none
  std::vector<Step> steps_;
};

class InsertionScheduler {
public:
  InsertionScheduler(Network const &network, Units const &units)
      : network_(network),
        units_(units),
        busy_(units.count.size()) {}

  // The tasks of greater priority are more urgent, then those of smaller id. Returns the length.
  Time run(std::span<Time const> priority, std::vector<Time> &start);

private:
  Network const &network_;
  Units const &units_;
  std::vector<Profile> busy_; // per kind
  PriorityOrder order_;
};

} // namespace symreal
