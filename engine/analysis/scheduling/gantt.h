// Gantt chart of a timetable: a row per unit, a bar per task.
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

// Writes SVG for light and dark pages; a title at each bar states the task, its begin and its end. Adjacent bars too
// narrow to see are merged. Tasks of zero duration are omitted.
void write_gantt(std::ostream &out, TaskGraph const &graph, Timetable const &timetable, GanttNames const &names);

} // namespace symreal
