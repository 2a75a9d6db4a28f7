// Task graphs as text, in the format of the Standard Task Graph set (T. Tobita and H. Kasahara, 2002): the number of
// tasks, then a line for each: its id, its processing time, the number of its predecessors, their ids. Comments begin
// with '#'. The published files begin and end with a dummy task, which takes no time and which the number leaves out;
// some have a number of units behind it, which is not used.
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

// The tasks in a topological order; apart from that in the order of the text. Throws task_graph_syntax and
// task_graph_cycle.
StgTasks read_stg(std::string_view text, std::string const &file_name);

// With a dummy task at each end, if the graph has none. `id` is empty, or has the ids to write; dummies that are added
// change them to numbers from 0 on, in the order of the tasks.
void write_stg(std::ostream &out, TaskGraph const &graph, std::vector<std::uint64_t> const &id);

} // namespace symreal
