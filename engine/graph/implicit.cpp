#include "engine/graph/implicit.h"

#include "engine/graph/graph.h"

#include <algorithm>

namespace symreal {

static constexpr char const *name = "implicit function"; // distinct from every C function name

External implicit_function(std::uint32_t count) {
  using Kind = ExternalValue::Kind;
  return {name, true, {}, {{Kind::input, count}, {Kind::input, count}, {Kind::output, count}}};
}

bool is_implicit(External const &external) { return external.name == name; }

bool is_well_formed_implicit(External const &external) {
  if (external.parameters.size() != 3 || !external.pure || external.parameters[0].count == 0) return false;
  External const form = implicit_function(external.parameters[0].count);
  return external.parameters == form.parameters && external.returned == form.returned;
}

bool is_implicit_call(Graph const &graph, NodeId id) {
  Node const &node = graph.nodes[id];
  return node.op == Op::call && is_implicit(graph.externals[function_of(graph, node)]);
}

bool is_implicit_solution(Graph const &graph, NodeId id) {
  Node const &node = graph.nodes[id];
  return node.op == Op::returned && is_implicit_call(graph, node.operand[0]);
}

ImplicitSystem system_of(Graph const &graph, NodeId call) {
  std::vector<NodeId> const all = arguments_of(graph, graph.nodes[call].operand[0]);
  auto const middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  return {{all.begin(), middle}, {middle, all.end()}};
}

Graph without_implicit(Graph graph) {
  if (std::ranges::none_of(graph.externals, is_implicit)) return graph;
  std::vector<NodeId> now(graph.nodes.size());
  for (NodeId id = 0; id < now.size(); ++id) {
    now[id] = id;
    if (is_implicit_solution(graph, id)) {
      Node const &node = graph.nodes[id];
      now[id] = now[system_of(graph, node.operand[0]).unknowns[result_of(graph, node)]];
    }
    Node &node = graph.nodes[id];
    if (is_leaf(node.op)) continue;
    for (NodeId &operand : node.operand)
      if (operand != no_node && graph.nodes[operand].op == Op::returned) operand = now[operand];
  }
  for (NodeId &result : graph.results) result = now[result];
  for (NodeId &constant : graph.precomputed) constant = now[constant];
  for (Guard &guard : graph.guards) guard.condition = now[guard.condition];
  return graph;
}

} // namespace symreal
