#include "tool/commands/optimise.h"

#include "passes/pass.h"

namespace symreal::tool {

static OperationCounts live_operations(Graph const &graph) {
  OperationCounts counts;
  std::vector<char> live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id]) ++counts[graph.nodes[id].op];
  return counts;
}

Optimised optimise(Graph const &recorded, PassOptions const &options) {
  PassSettings const settings = options.settings();
  Optimised result{recorded, {{"recorded", live_operations(recorded)}}};
  for (std::string const &pass : options.names()) {
    result.graph = run_passes(std::move(result.graph), {&pass, 1}, settings);
    result.stages.push_back({pass, live_operations(result.graph)});
  }
  return result;
}

} // namespace symreal::tool
