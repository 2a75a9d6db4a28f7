// Output of `symreal schedule`.
#pragma once

#include "engine/analysis/scheduling/scheduler.h"
#include "tool/scheduling/unit_option.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>

namespace symreal::tool {

struct ScheduleReport {
  TaskInput const *input;
  NamedUnits const *units;
  Solution const *solution;
};

// Prints length, bounds, gap, and the load of each unit.
void print_summary(std::ostream &out, ScheduleReport const &report);
nlohmann::ordered_json summary_json(ScheduleReport const &report);

// Writes the tasks in order of their begin.
void write_csv(std::ostream &out, ScheduleReport const &report);
nlohmann::ordered_json timetable_json(ScheduleReport const &report);

} // namespace symreal::tool
