// Connected components of a task graph, regardless of edge direction. Operations that share only inputs or constants,
// which are not tasks, are not connected. Linear time.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

namespace symreal {

struct Components {
  std::vector<std::uint32_t> of_task; // numbered in order of their first tasks
  std::vector<std::size_t> tasks;     // per component: tasks of nonzero duration
  std::vector<Time> work;             // per component: total duration

  // Number of components with a task of nonzero duration.
  std::size_t count() const;
  std::size_t largest() const;
};
Components components(TaskGraph const &graph);

} // namespace symreal
