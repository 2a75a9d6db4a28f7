// List scheduling with a choice of unit for each task, given communication delays.
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
