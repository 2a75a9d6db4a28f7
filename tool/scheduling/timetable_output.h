// What `symreal schedule` says and writes.
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

// Length, bounds, gap, and how busy each unit is.
void print_summary(std::ostream &out, ScheduleReport const &report);
nlohmann::ordered_json summary_json(ScheduleReport const &report);

// The tasks in the order in which they begin.
void write_csv(std::ostream &out, ScheduleReport const &report);
nlohmann::ordered_json timetable_json(ScheduleReport const &report);

} // namespace symreal::tool
