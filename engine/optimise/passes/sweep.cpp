#include "engine/optimise/passes/sweep.h"

#include <bit>

namespace symreal {

namespace {

// Set of operations as a 64-bit Bloom filter: several may share a bit.
using OperationSet = std::uint64_t;

OperationSet only(Op op) { return OperationSet{1} << static_cast<unsigned>(op) % 64; }

// Operations required among the operands for the rule to apply. This filter rejects most rules.
OperationSet needs_of(Rule const &rule) {
  OperationSet needs = 0;
  for (Term const &term : rule.pattern.operands)
    if (term.kind == Term::Kind::operation)
      needs |= only(term.op);
    else if (term.kind == Term::Kind::number || term.variable == 'k')
      needs |= only(Op::constant);
  return needs;
}

class Sweep {
public:
  explicit Sweep(SweepOptions const &options) : options_(options) {
    for (Rule const &rule : rules())
      if ((options.topics & static_cast<unsigned>(rule.topic)) && rule.mode <= options.mode)
        rules_[static_cast<std::size_t>(rule.pattern.op)].push_back({&rule, needs_of(rule)});
  }

  Graph run(Graph const &graph) {
    std::vector<NodeId> now(graph.nodes.size());
    table_.reserve(graph.nodes.size());
    for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
      Node const &node = graph.nodes[id];
      if (is_leaf(node.op)) {
        now[id] = table_.intern(node);
        continue;
      }
      node_ = static_cast<NodeId>(id);
      exact_ = !graph.node_exact.empty() && graph.node_exact[id];
      std::array<NodeId, 3> operand = node.operand;
      for (NodeId &o : operand)
        if (o != no_node) o = now[o];
      now[id] = make(node.op, operand);
    }
    Graph result = without_nodes(graph);
    result.nodes = table_.release();
    result.node_exact = std::move(exact_nodes_);
    carry_over(graph, now, result);
    return result;
  }

private:
  // The replacement of an exact node is exact.
  NodeId intern(Node const &node) {
    NodeId const id = table_.intern(node);
    if (exact_) {
      if (id >= exact_nodes_.size()) exact_nodes_.resize(id + 1, 0);
      exact_nodes_[id] = 1;
    }
    return id;
  }

  // Recursion is bounded: a replacement has at most three operations, and each lets a sign move outwards only.
  NodeId make(Op op, std::array<NodeId, 3> operand) {
    if (options_.canonical_order && info(op).has(flag::COMMUTATIVE) && is_newer(operand[0], operand[1], table_))
      std::swap(operand[0], operand[1]);
    Node node = table_.operation(op, operand[0], operand[1], operand[2]);
    if (info(op).has(flag::OPAQUE)) return intern(node);
    if (options_.fold && node.attribute == Attribute::constant && op != Op::wide)
      return may_rewrite(nullptr) ? fold(node) : intern(node);
    OperationSet operands = 0;
    for (NodeId const id : operand)
      if (id != no_node) operands |= only(table_[id].op);
    Bindings bindings;
    for (auto const &[rule, needs] : rules_[static_cast<std::size_t>(op)])
      if ((needs & ~operands) == 0 && !(exact_ && rule->mode == FloatingPoint::fast) &&
          match(*rule, node, table_, bindings))
        return may_rewrite(rule) ? build(rule->replacement, bindings) : intern(node);
    return intern(node);
  }

  bool may_rewrite(Rule const *rule) {
    RewriteLimit *const limit = options_.limit;
    if (!limit) return true;
    if (limit->done == limit->most) return false;
    ++limit->done;
    limit->last = rule;
    limit->last_node = node_;
    return true;
  }

  NodeId build(Term const &term, Bindings &bindings) {
    switch (term.kind) {
    case Term::Kind::variable: return bindings[term.variable];
    case Term::Kind::number: return table_.constant(term.number);
    case Term::Kind::operation: break;
    }
    std::array<NodeId, 3> operand = {no_node, no_node, no_node};
    bool constant = true;
    for (std::size_t i = 0; i < term.operands.size(); ++i) {
      operand[i] = build(term.operands[i], bindings);
      constant = constant && table_[operand[i]].is_constant();
    }
    if (constant) return fold(table_.operation(term.op, operand[0], operand[1], operand[2]));
    return make(term.op, operand);
  }

  NodeId fold(Node const &node) {
    double const value =
        evaluate(node.op, value_of(node.operand[0]), value_of(node.operand[1]), value_of(node.operand[2]));
    if (!is_wide(node.op)) return table_.constant(value);
    auto const bits = std::bit_cast<std::uint64_t>(value);
    NodeId const high = table_.constant(static_cast<double>(bits >> 32));
    return table_.intern(
        table_.operation(Op::wide, high, table_.constant(static_cast<double>(bits & 0xFFFFFFFFu)), no_node));
  }

  // Value of a constant; a 64-bit integer is a node of its two halves.
  double value_of(NodeId id) const {
    if (id == no_node) return 0;
    Node const &node = table_[id];
    return node.is_constant() ? node.value()
                              : evaluate(node.op, value_of(node.operand[0]), value_of(node.operand[1]), 0);
  }

  SweepOptions options_;
  struct Candidate {
    Rule const *rule;
    OperationSet needs;
  };

  std::array<std::vector<Candidate>, static_cast<std::size_t>(Op::count)> rules_;
  NodeTable table_;
  NodeId node_ = no_node; // node of the input graph in progress
  bool exact_ = false;    // whether that node is exact
  std::vector<char> exact_nodes_;
};

} // namespace

Graph sweep(Graph const &graph, SweepOptions const &options) { return Sweep(options).run(graph); }

} // namespace symreal
