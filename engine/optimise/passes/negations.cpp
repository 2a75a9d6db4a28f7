#include "engine/optimise/passes/groups.h"
#include "engine/optimise/passes/pass.h"

namespace symreal {

// Pass `signs` leaves one canonical node for a value and its negative, and a `neg` for each use of the negative. If
// that `neg` is the node's only use, this pass computes the negative directly: -(a - b) becomes b - a, -(a * k) becomes
// a * -k. It reverses the rules of `signs`, so it runs once, at the end.
Graph pass_negations(Graph graph, PassSettings const &settings) {
  std::vector<std::uint32_t> const uses = use_counts(graph);

  // The negative of `node` as one operation, else nullopt. b - a for -(a - b) differs in the sign of zero.
  NodeTable table;
  table.reserve(graph.nodes.size());
  auto negative = [&](Node node) -> std::optional<Node> {
    auto constant = [&](int i) { return table[node.operand[i]].is_constant(); };
    auto negate = [&](int i) { node.operand[i] = table.constant(-table[node.operand[i]].value()); };
    switch (node.op) {
    case Op::sub:
      if (settings.mode == FloatingPoint::strict) return std::nullopt;
      std::swap(node.operand[0], node.operand[1]);
      return node;
    case Op::mul:
    case Op::div:
      if (constant(1))
        negate(1);
      else if (constant(0))
        negate(0);
      else
        return std::nullopt;
      return node;
    default: return std::nullopt;
    }
  };

  std::vector<NodeId> now(graph.nodes.size(), no_node);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node node = graph.nodes[id];
    if (!is_leaf(node.op))
      for (NodeId &operand : node.operand)
        if (operand != no_node) operand = now[operand];
    std::optional<Node> direct;
    if (node.op == Op::neg && uses[graph.nodes[id].operand[0]] == 1) direct = negative(table[node.operand[0]]);
    now[id] = table.intern(direct.value_or(node));
  }
  Graph result = without_nodes(graph);
  result.nodes = table.release();
  if (!graph.node_exact.empty()) {
    // The negative of an exact node is exact.
    result.node_exact.resize(result.nodes.size(), 0);
    for (std::size_t id = 0; id < graph.nodes.size(); ++id)
      if (graph.nodes[id].op == Op::neg && graph.node_exact[graph.nodes[id].operand[0]]) result.node_exact[now[id]] = 1;
  }
  carry_over(graph, now, result);
  keep_nodes(result, live_nodes(result));
  return result;
}

} // namespace symreal
