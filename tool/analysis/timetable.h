// Timetable of tasks on units: its tasks, from a task graph as text or a recorded graph whose operations they are; its
// units; and what is said of it.
#pragma once

#include "engine/analysis/scheduling/scheduler.h"
#include "engine/analysis/scheduling/timetable.h"
#include "engine/analysis/tasks/task_graph.h"
#include "engine/ops/operation.h"

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace symreal::tool {

struct TaskInput {
  std::string file;
  TaskGraph tasks;
  std::vector<std::uint64_t> id; // of a textual task graph: identifier per task
  std::vector<Op> operation;     // of a recorded graph: operation per task
  std::vector<std::string> name; // per task: "12" of a task graph, "%12 mul" of a recorded one

  bool is_recorded() const { return !operation.empty(); }
};

// Reads the input. `cost`: unit, table, or empty: unit, and may have no effect.
TaskInput read_tasks(std::string const &file, std::string const &cost);

// Units of --units.
struct NamedUnits {
  Units units;
  std::vector<std::string> name; // per unit
};

// Reads "4", or for a recorded graph "mul=2,arithmetic=1,other=1". A kind is an operation, a group, or `other`; an
// operation takes the first of these that is listed. Sets the tasks' kinds. Throws bad_option and no_unit.
NamedUnits read_units(std::string const &words, Time communication, TaskInput &input);

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
