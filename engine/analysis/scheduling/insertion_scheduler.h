// Insertion scheduling: takes the most urgent task among those whose predecessors are placed, and places it in the
// earliest gap that fits, between placed tasks. Every timetable in which no task can move to an earlier time results
// from some order; a shortest one is among them (J. E. Kelley, 1963).
#pragma once

#include "engine/analysis/scheduling/priority_order.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

// Number of busy units of one kind over time.
class Profile {
public:
  void clear() { steps_.assign(1, {0, 0}); }
  // Reserves a unit for `duration` at the earliest begin from `earliest` on; returns the begin.
  Time place(Time earliest, Time duration, unsigned units);

private:
  struct Step {
    Time at; // until the next step
    unsigned busy;
  };
  std::size_t step_at(Time at); // the step that begins at `at`; made if absent
  std::vector<Step> steps_;
};

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

} // namespace symreal
