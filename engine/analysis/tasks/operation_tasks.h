// Operation tasks: the operations of a graph as tasks.
#pragma once

#include "engine/analysis/tasks/task_graph.h"
#include "engine/graph/graph.h"

#include <array>

namespace symreal {

// Cost of each operation, indexed by Op. Leaves cost 0.
using OperationCosts = std::array<Time, static_cast<std::size_t>(Op::count)>;

// 1 for each operation, 0 for those that are free in the cost table: changes of sign, argument lists.
OperationCosts unit_costs();
// Column `cost` of the operation table.
OperationCosts table_costs();

// Operations of function `compute`: the live operations that depend on an input or that it recomputes, or all live ones
// if the graph has no `preprocess`. Stored values, constants, inputs and parameters exist from the start.
struct OperationTasks {
  TaskGraph tasks;
  std::vector<NodeId> node; // per task, ascending
};
OperationTasks operation_tasks(Graph const &graph, OperationCosts const &costs);

} // namespace symreal
