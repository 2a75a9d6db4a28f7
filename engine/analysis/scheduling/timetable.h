// When each task begins and which unit does it, and whether that is possible.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

#include <optional>
#include <string>

namespace symreal {

// What does the work. Units are numbered kind by kind.
struct Units {
  std::vector<unsigned> count; // per kind of task
  Time communication = 0;      // after a task, before its successor can begin on another unit

  unsigned total() const;
  unsigned first_of(std::size_t kind) const;
};

struct Timetable {
  std::vector<Time> start;
  std::vector<std::uint32_t> unit;
};

// When the last task ends.
Time length(TaskGraph const &graph, std::vector<Time> const &start);

// Units for tasks of which never more run at once than there are units of their kind. Knows no communication.
Timetable assign_units(TaskGraph const &graph, Units const &units, std::vector<Time> const &start);

// Dummy tasks take no time and begin or end the graph: nothing is communicated from or to them.
std::vector<char> dummies(TaskGraph const &graph);

// What is wrong with a timetable, in words; nothing if it can be done as it is.
std::optional<std::string> fault(TaskGraph const &graph, Units const &units, Timetable const &timetable);

} // namespace symreal
