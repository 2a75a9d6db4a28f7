#include "engine/optimise/passes/groups.h"

namespace symreal {

namespace {

bool is_of_group(Op group, Op op) { return group == Op::add ? op == Op::add || op == Op::sub : op == Op::mul; }

// Groups of a graph, indexed by their end nodes.
class Groups {
public:
  explicit Groups(Graph const &graph)
      : graph_(graph),
        uses_(use_counts(graph)),
        number_(graph.nodes.size(), no_group),
        is_inside_(graph.nodes.size(), 0) {
    std::vector<char> const live = live_nodes(graph);
    for (auto id = static_cast<NodeId>(graph.nodes.size()); id-- > 0;) {
      if (!live[id] || is_inside_[id] || !is_regrouped(id)) continue;
      Op const op = graph.nodes[id].op == Op::sub ? Op::add : graph.nodes[id].op;
      if (op == Op::add || op == Op::mul) collect(op, id);
    }
  }

  // The group that ends in the node, else null.
  Group const *ending_in(NodeId id) const { return number_[id] == no_group ? nullptr : &groups_[number_[id]]; }

private:
  static constexpr std::uint32_t no_group = ~std::uint32_t{0};

  bool is_regrouped(NodeId id) const {
    bool const is_exact = !graph_.node_exact.empty() && graph_.node_exact[id];
    return !is_exact && graph_.nodes[id].attribute == Attribute::variable;
  }

  void collect(Op op, NodeId end) {
    Group group{op, end, {}};
    std::vector<SignedNode> open = {{end}};
    while (!open.empty()) {
      auto const [id, is_negative] = open.back();
      open.pop_back();
      Node const &node = graph_.nodes[id];
      bool const is_open = id == end || (uses_[id] == 1 && is_regrouped(id));
      if (is_open && is_of_group(op, node.op)) {
        if (id != end) is_inside_[id] = 1;
        // The first operand is popped first. One factor carries the sign of a product.
        open.push_back({node.operand[1], op == Op::add && is_negative != (node.op == Op::sub)});
        open.push_back({node.operand[0], is_negative});
      } else if (is_open && node.op == Op::neg) {
        open.push_back({node.operand[0], !is_negative});
      } else {
        group.terms.push_back({id, is_negative});
      }
    }
    if (group.terms.size() < 3) return;
    number_[end] = static_cast<std::uint32_t>(groups_.size());
    groups_.push_back(std::move(group));
  }

  Graph const &graph_;
  std::vector<std::uint32_t> uses_, number_;
  std::vector<char> is_inside_;
  std::vector<Group> groups_;
};

} // namespace

std::vector<std::uint32_t> use_counts(Graph const &graph) {
  std::vector<std::uint32_t> uses(graph.nodes.size(), 0);
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!live[id] || is_leaf(graph.nodes[id].op)) continue;
    for (NodeId operand : graph.nodes[id].operand)
      if (operand != no_node) ++uses[operand];
  }
  for_each_root(graph, [&](NodeId root) { ++uses[root]; });
  return uses;
}

SignedNode combined(Op op, SignedNode a, SignedNode b, NodeTable &table) {
  bool const differ = a.is_negative != b.is_negative, is_sum = op == Op::add;
  if (is_sum && differ && a.is_negative) std::swap(a, b);
  Op const made = is_sum && differ ? Op::sub : op;
  SignedNode result{no_node, is_sum ? a.is_negative : differ};
  Node const node = table.operation(made, a.node, b.node);
  if (node.attribute == Attribute::constant)
    result.node = table.constant(evaluate(made, table[a.node].value(), table[b.node].value(), 0));
  else
    result.node = table.intern(node);
  return result;
}

Graph regrouped(Graph const &graph, BuildGroup const &build) {
  Groups const groups(graph);
  NodeTable table;
  std::vector<NodeId> now(graph.nodes.size(), no_node);
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    if (Group const *old = groups.ending_in(id)) {
      Group group = *old;
      for (SignedNode &term : group.terms) term.node = now[term.node];
      if (std::optional<SignedNode> const built = build(group, table)) {
        now[id] = built->is_negative ? table.intern(table.operation(Op::neg, built->node)) : built->node;
        continue;
      }
    }
    Node node = graph.nodes[id];
    if (!is_leaf(node.op))
      for (NodeId &operand : node.operand)
        if (operand != no_node) operand = now[operand];
    now[id] = table.intern(node);
  }
  Graph result = without_nodes(graph);
  result.nodes = table.release();
  carry_over(graph, now, result);
  keep_nodes(result, live_nodes(result));
  return result;
}

} // namespace symreal
