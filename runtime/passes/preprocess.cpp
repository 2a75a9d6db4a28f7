#include "passes/pass.h"

namespace symreal {

// The boundary between the two functions: every parametric node that the variable part or an output uses directly gets
// a slot of `constants`, a bare parameter too, since `compute` sees no parameters. What lies behind the boundary is
// parametric by definition of the attribute and so runs in `preprocess`.
Graph pass_preprocess(Graph const &graph, PassSettings const &) {
  std::vector<char> live = live_nodes(graph), stored(graph.nodes.size(), 0);
  auto is_parametric = [&](NodeId id) { return graph.nodes[id].attribute == Attribute::parametric; };
  // A list of arguments cannot be stored, but what it holds can.
  auto store = [&](NodeId operand) {
    for (; is_parametric(operand) && graph.nodes[operand].op == Op::argument; operand = graph.nodes[operand].operand[0])
      if (NodeId value = graph.nodes[operand].operand[1]; is_parametric(value)) stored[value] = 1;
    if (is_parametric(operand)) stored[operand] = 1;
  };
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!live[id] || is_leaf(node.op) || node.attribute != Attribute::variable) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node) store(operand);
  }
  for (NodeId root : graph.results)
    if (is_parametric(root)) stored[root] = 1;
  for (Guard const &guard : graph.guards)
    if (is_parametric(guard.condition)) stored[guard.condition] = 1;
  Graph result = graph;
  result.precomputed.clear();
  for (std::size_t id = 0; id < stored.size(); ++id)
    if (stored[id]) result.precomputed.push_back(static_cast<NodeId>(id));
  return result;
}

} // namespace symreal
