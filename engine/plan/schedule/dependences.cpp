#include "engine/plan/schedule/dependences.h"

namespace symreal {

std::vector<char> needed_operations(Plan const &plan, FunctionKind kind, std::vector<NodeId> const &roots) {
  Graph const &graph = *plan.graph;
  std::vector<char> needed(graph.nodes.size(), 0);
  for (NodeId const root : roots) needed[root] = 1;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    if (!needed[id]) continue;
    if (is_read(plan, kind, static_cast<NodeId>(id))) {
      needed[id] = 0;
      continue;
    }
    for (NodeId const operand : graph.nodes[id].operand)
      if (operand != no_node) needed[operand] = 1;
  }
  return needed;
}

bool waits_for_other_parts(Plan const &plan, PlanFunction const &body, std::size_t part) {
  auto const begin_of = [&](std::size_t k) { return k == 0 ? 0 : body.parts[k - 1].end; };
  std::size_t stage_begin = begin_of(part);
  for (std::size_t k = part; k-- > 0 && body.parts[k].stage == body.parts[part].stage;) stage_begin = begin_of(k);
  std::vector<char> is_variable(body.regions.value_count(), 0), is_others(body.regions.value_count(), 0);
  for (std::size_t k = 0; k < body.parts[part].end; ++k) {
    is_variable[body.variables[k]] = 1;
    is_others[body.variables[k]] = k >= stage_begin && k < begin_of(part);
  }
  bool waits = false;
  for (std::size_t k = begin_of(part); k < body.parts[part].end; ++k)
    for_each_before(
        plan, body, k, [&](NodeId id) { return is_variable[id] != 0; },
        [&](NodeId before) { waits |= is_others[before] != 0; });
  return waits;
}

} // namespace symreal
