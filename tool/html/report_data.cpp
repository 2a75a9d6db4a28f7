#include "tool/html/report_data.h"

#include "engine/support/version.h"
#include "tool/analysis/figures_report.h"
#include "tool/html/data.h"

namespace symreal::tool {

// Timetable of `compute` on units, as by `schedule`.
static Json timetable(Graph const &graph, OperationTasks const &operations, std::string const &units) {
  TaskInput input;
  input.tasks = operations.tasks;
  for (NodeId node : operations.node) input.operation.push_back(graph.nodes[node].op);
  NamedUnits const named = read_units(units, 0, input);
  Solution const solution = schedule_tasks(input.tasks, named.units, Effort());
  return timetable_data(graph, {&input, &named, &solution}, operations.node);
}

Json report_data(ReportRequest const &request, Sources const &sources) {
  Graph const &graph = *request.kernel.graph;
  Figures const all = figures(graph, request.costs, {});
  return {{"tool", version},
          {"mode", to_string(request.mode)},
          {"time_scale", request.costs.scale},
          {"kernel", to_json(request.kernel)},
          {"figures", to_json(graph, request.costs, all)},
          {"profiles", profile_data(all)},
          {"sources", source_data(sources)},
          {"code", code_data(graph, request.mode, sources)},
          {"graph", node_data(graph, all, sources)},
          {"timetable", timetable(graph, all.operations, request.units)},
          {"verification", request.verification}};
}

} // namespace symreal::tool
