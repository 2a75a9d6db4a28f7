// Reader and writer of task graphs in the format of the Standard Task Graph set (T. Tobita and H. Kasahara, 2002): the
// number of tasks, then a line per task: its id, its processing time, the number of its predecessors, their ids.
// Comments begin with '#'. The published files begin and end with a dummy task of zero duration, which the number
// excludes; in some, an unused number of units follows it.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace symreal {

struct StgTasks {
  TaskGraph tasks;
  std::vector<std::uint64_t> id; // per task, as in the text
};

// Reads the tasks, in the topological order closest to the text's. Throws task_graph_syntax and task_graph_cycle.
StgTasks read_stg(std::string_view text, std::string const &file_name);

// Adds a dummy task at each end if the graph lacks them. `id` has the ids to write, or is empty; added dummies renumber
// the tasks from 0 on in their order.
void write_stg(std::ostream &out, TaskGraph const &graph, std::vector<std::uint64_t> const &id);

} // namespace symreal
