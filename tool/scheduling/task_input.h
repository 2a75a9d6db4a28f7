// Input of `symreal schedule`: a task graph as text, or a recorded graph whose operations are the tasks.
#pragma once

#include "engine/analysis/tasks/task_graph.h"
#include "engine/ops/operation.h"

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

} // namespace symreal::tool
