#include "tool/scheduling/task_input.h"

#include "engine/analysis/tasks/operation_tasks.h"
#include "engine/analysis/tasks/stg.h"
#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph_text.h"
#include "engine/support/files.h"
#include "tool/options/options.h"

#include <algorithm>

namespace symreal::tool {
namespace {

// Does the first line other than comments begin the text of a graph?
bool is_graph(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size() && (text[at] == ';' || text[at] == '\n' || text[at] == '\r'))
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return text.substr(at).starts_with("symreal-graph");
}

void read_recorded(TaskInput &input, std::string const &text, std::string const &cost) {
  require_one_of("--cost", cost, "unit|table");
  Graph const graph = read_graph(text, input.file);
  OperationTasks const read = operation_tasks(graph, cost == "table" ? table_costs() : unit_costs());
  input.tasks = read.tasks;
  std::vector<NodeId> const number = line_numbers(graph);
  for (NodeId node : read.node) {
    Op const op = graph.nodes[node].op;
    input.operation.push_back(op);
    input.name.push_back("%" + std::to_string(number[node]) + " " + std::string(info(op).name));
  }
}

} // namespace

TaskInput read_tasks(std::string const &file, std::string const &cost) {
  TaskInput input{file, {}, {}, {}, {}};
  std::string const text = read_file(file);
  if (is_graph(text)) {
    read_recorded(input, text, cost.empty() ? "unit" : cost);
  } else {
    if (!cost.empty())
      fail(DiagnosticId::option_without_effect, {},
           "--cost is for recorded graphs, and '" + file + "' has processing times");
    StgTasks read = read_stg(text, file);
    input.tasks = std::move(read.tasks);
    input.id = std::move(read.id);
    for (std::uint64_t id : input.id) input.name.push_back(std::to_string(id));
  }
  return input;
}

} // namespace symreal::tool
