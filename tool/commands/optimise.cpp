#include "tool/commands/optimise.h"

#include "passes/pass.h"

#include <iostream>

namespace symreal::tool {

static OperationCounts live_operations(Graph const &graph) {
  OperationCounts counts;
  std::vector<char> live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id]) ++counts[graph.nodes[id].op];
  return counts;
}

Optimised optimise(Graph const &recorded, PassOptions const &options, Report const &report) {
  PassSettings const settings = options.settings();
  Optimised result{recorded, {{"recorded", live_operations(recorded)}}};
  Report const tell = report ? report : [](Diagnostic const &remark) { print(std::cerr, remark); };
  if (std::optional<double> const distance = options.snap_distance()) {
    result.graph = with_exact_constants(recorded, *distance, options.tolerance, tell);
    result.stages.push_back({"snap", live_operations(result.graph)});
  } else if (settings.mode == FloatingPoint::fast && !options.names().empty()) {
    tell_of_exact_constants(recorded, settings, tell);
  }
  for (std::string const &pass : options.names()) {
    result.graph = run_passes(std::move(result.graph), {&pass, 1}, settings);
    result.stages.push_back({pass, live_operations(result.graph)});
  }
  return result;
}

} // namespace symreal::tool
