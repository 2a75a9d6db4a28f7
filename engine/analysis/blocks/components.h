// Tasks that have nothing to do with each other: the connected components of a graph, whatever way its edges point.
// Operations that only share inputs or constants are not connected, as these are no tasks. Linear.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

namespace symreal {

struct Components {
  std::vector<std::uint32_t> of_task; // numbered by their first tasks
  std::vector<std::size_t> tasks;     // per component: how many last some time
  std::vector<Time> work;             // per component: all durations together

  // Those in which something lasts some time.
  std::size_t count() const;
  std::size_t largest() const;
};
Components components(TaskGraph const &graph);

} // namespace symreal
