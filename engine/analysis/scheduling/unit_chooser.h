// List scheduling that chooses a unit for each task, where results take time from unit to unit.
#pragma once

#include "engine/analysis/scheduling/priority_order.h"
#include "engine/analysis/scheduling/timetable.h"

namespace symreal {

class UnitChooser {
public:
  UnitChooser(Network const &network, Units const &units, std::vector<char> const &is_dummy)
      : network_(network),
        units_(units),
        is_dummy_(is_dummy),
        busy_(units.total()),
        data_(units.total()) {}

  // Takes the tasks one by one, the most urgent among those whose predecessors are placed. Each goes to the earliest
  // gap of its unit in `fixed`; without that, of the unit in which it ends first. Returns the length.
  Time run(std::span<Time const> priority, std::vector<std::uint32_t> const *fixed, Timetable &result);

private:
  struct Busy {
    Time from, until;
  };
  struct Gap {
    Time begin;
    std::size_t before; // the place in the busy times of the unit
  };
  void find_data(TaskId task, Timetable const &result);
  Gap earliest_gap(std::uint32_t unit, TaskId task) const;
  void place(TaskId task, std::vector<std::uint32_t> const *fixed, Timetable &result);

  Network const &network_;
  Units const &units_;
  std::vector<char> const &is_dummy_;
  std::vector<std::vector<Busy>> busy_; // per unit, in order
  std::vector<Time> data_;              // per unit: when it has what the task needs
  PriorityOrder order_;
};

} // namespace symreal
