// A timetable as a picture: a row for each unit, a bar for each task.
#pragma once

#include "engine/analysis/scheduling/timetable.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace symreal {

struct GanttNames {
  std::string title;
  std::vector<std::string> task, unit;
};

// SVG for light and dark pages; a title at each bar says the task, its begin and its end. Neighbours that are too short
// to be seen are one bar. Tasks that take no time are left out.
void write_gantt(std::ostream &out, TaskGraph const &graph, Timetable const &timetable, GanttNames const &names);

} // namespace symreal
