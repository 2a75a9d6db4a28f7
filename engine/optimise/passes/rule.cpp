#include "engine/optimise/passes/rule.h"

#include <bit>
#include <cmath>

namespace symreal {

namespace {

bool is_truth(Node const &node) { return !is_leaf(node.op) && info(node.op).has(flag::BOOLEAN); }

bool match_number(double wanted, double value, FloatingPoint mode) {
  if (mode == FloatingPoint::strict) return std::bit_cast<std::uint64_t>(wanted) == std::bit_cast<std::uint64_t>(value);
  return wanted == value;
}

bool may_stand_for(char letter, Node const &node) {
  switch (letter) {
  case 'k': return node.is_constant();
  case 'p': return node.attribute == Attribute::parametric;
  default: return true;
  }
}

// Patterns are at most two operations deep, so the rule table bounds the recursion, not the graph.
bool match_term(Term const &term, FloatingPoint mode, NodeId id, NodeTable const &table, Bindings &bindings) {
  Node const &node = table[id];
  switch (term.kind) {
  case Term::Kind::number: return node.is_constant() && match_number(term.number, node.value(), mode);
  case Term::Kind::variable:
    if (!may_stand_for(term.variable, node)) return false;
    if (bindings[term.variable] == no_node) bindings[term.variable] = id;
    return bindings[term.variable] == id;
  case Term::Kind::operation: break;
  }
  if (node.op != term.op) return false;
  for (std::size_t i = 0; i < term.operands.size(); ++i)
    if (!match_term(term.operands[i], mode, node.operand[i], table, bindings)) return false;
  return true;
}

// Quick reject by the operand's own node; most rules fail here.
bool may_match(Term const &term, Node const &node) {
  switch (term.kind) {
  case Term::Kind::number: return node.is_constant();
  case Term::Kind::variable: return may_stand_for(term.variable, node);
  case Term::Kind::operation: break;
  }
  return node.op == term.op;
}

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

std::span<Rule const> rules() {
  static std::vector<Rule> const table = {
#define RULE(topic, mode, pattern, replacement, condition, counterexample)                                             \
  {Topic::topic,        FloatingPoint::mode,    pattern, replacement, counterexample, Condition::condition,            \
   parse_term(pattern), parse_term(replacement)},
#include "engine/optimise/passes/rules.def"
#undef RULE
  };
  return table;
}

bool is_newer(NodeId a, NodeId b, NodeTable const &table) {
  bool a_constant = table[a].is_constant(), b_constant = table[b].is_constant();
  return a_constant != b_constant ? a_constant : a > b;
}

bool holds_for_value(Condition condition, double k) {
  switch (condition) {
  case Condition::always:
  case Condition::x_newer:
  case Condition::x_truth:
  case Condition::x_variable: return true;
  case Condition::k_negative: return k < 0;
  case Condition::k_zero: return k == 0;
  case Condition::k_nonzero: return k != 0;
  case Condition::k_has_exact_inverse: {
    int exponent = 0;
    return std::isnormal(k) && std::isnormal(1 / k) && std::fabs(std::frexp(k, &exponent)) == 0.5;
  }
  }
  return false;
}

bool match(Rule const &rule, Node const &node, NodeTable const &table, Bindings &bindings) {
  std::array<NodeId, 3> operand = node.operand;
  for (bool exchanged : {false, true}) {
    if (exchanged) {
      if (!info(node.op).has(flag::COMMUTATIVE)) return false;
      std::swap(operand[0], operand[1]);
    }
    std::vector<Term> const &terms = rule.pattern.operands;
    bool matched = true;
    for (std::size_t i = 0; matched && i < terms.size(); ++i) matched = may_match(terms[i], table[operand[i]]);
    if (!matched) continue;
    bindings.node.fill(no_node);
    for (std::size_t i = 0; matched && i < terms.size(); ++i)
      matched = match_term(terms[i], rule.mode, operand[i], table, bindings);
    if (!matched) continue;
    if (rule.condition == Condition::x_newer && !is_newer(bindings['x'], bindings['y'], table)) continue;
    if (rule.condition == Condition::x_truth && !is_truth(table[bindings['x']])) continue;
    if (rule.condition == Condition::x_variable && table[bindings['x']].attribute != Attribute::variable) continue;
    double k = bindings['k'] == no_node ? 0 : table[bindings['k']].value();
    if (holds_for_value(rule.condition, k)) return true;
  }
  return false;
}

Graph sweep(Graph const &graph, SweepOptions const &options) { return Sweep(options).run(graph); }

} // namespace symreal
