// The operations of a graph as tasks.
#pragma once

#include "engine/analysis/tasks/task_graph.h"
#include "engine/graph/graph.h"

#include <array>

namespace symreal {

// What each operation costs, by Op. Leaves cost nothing.
using OperationCosts = std::array<Time, static_cast<std::size_t>(Op::count)>;

// 1 for each operation, 0 for what costs nothing in the table: changes of sign, lists of arguments.
OperationCosts unit_costs();
// Column `cost` of the table of operations.
OperationCosts table_costs();

// What function `compute` does: the live operations that depend on an input, or all live ones if the graph has no
// `preprocess`. What `preprocess` has stored, constants, inputs and parameters are there from the beginning.
struct OperationTasks {
  TaskGraph tasks;
  std::vector<NodeId> node; // per task, ascending
};
OperationTasks operation_tasks(Graph const &graph, OperationCosts const &costs);

} // namespace symreal
