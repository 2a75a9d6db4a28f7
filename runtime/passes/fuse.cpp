#include "graph/node_table.h"
#include "passes/compact.h"
#include "passes/pass.h"

namespace symreal {

// x*y + z becomes fma(x, y, z), which has one rounding less and so another value. A product that somebody else needs is
// computed anyway, and stays: this is what a rule, which sees one operation at a time, could not tell.
Graph pass_fuse(Graph const &graph, FloatingPoint mode) {
  if (mode != FloatingPoint::fast) return graph;
  std::vector<std::uint32_t> uses(graph.nodes.size(), 0);
  for (Node const &node : graph.nodes)
    if (!is_leaf(node.op))
      for (NodeId operand : node.operand)
        if (operand != no_node) ++uses[operand];
  for_each_root(graph, [&](NodeId root) { ++uses[root]; });

  NodeTable table;
  std::vector<NodeId> now(graph.nodes.size(), no_node);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node node = graph.nodes[id];
    std::optional<Node> fused;
    for (int i = 0; node.op == Op::add && i < 2 && !fused; ++i) {
      Node const &product = graph.nodes[node.operand[i]];
      if (product.op == Op::mul && uses[node.operand[i]] == 1)
        fused = table.operation(Op::fma, now[product.operand[0]], now[product.operand[1]], now[node.operand[1 - i]]);
    }
    if (!is_leaf(node.op))
      for (NodeId &operand : node.operand)
        if (operand != no_node) operand = now[operand];
    now[id] = table.intern(fused.value_or(node));
  }
  Graph result = without_nodes(graph);
  result.nodes = table.release();
  carry_over(graph, now, result);
  return compact(result, live_nodes(result));
}

} // namespace symreal
