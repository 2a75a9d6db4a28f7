// Timetables: the start and unit of each task, and their validation.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

#include <optional>
#include <string>

namespace symreal {

// Execution units, numbered kind by kind.
struct Units {
  std::vector<unsigned> count; // per kind of task
  Time communication = 0;      // delay between a task and its successor on another unit

  unsigned total() const;
  unsigned first_of(std::size_t kind) const;
};

struct Timetable {
  std::vector<Time> start;
  std::vector<std::uint32_t> unit;
};

// Assigns units to tasks that never exceed the units of their kind. Ignores communication.
Timetable assign_units(TaskGraph const &graph, Units const &units, std::vector<Time> const &start);

// Marks dummy tasks: sources and sinks of zero duration, which need no communication.
std::vector<char> dummies(TaskGraph const &graph);

// Description of a timetable's fault; nullopt if it is valid.
std::optional<std::string> fault(TaskGraph const &graph, Units const &units, Timetable const &timetable);

} // namespace symreal
