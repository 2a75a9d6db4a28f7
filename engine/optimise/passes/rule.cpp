#include "engine/optimise/passes/rule.h"

#include <bit>
#include <cmath>

namespace symreal {

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

static bool is_truth(Node const &node) { return !is_leaf(node.op) && info(node.op).has(flag::BOOLEAN); }

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

static bool match_number(double wanted, double value, FloatingPoint mode) {
  if (mode == FloatingPoint::strict) return std::bit_cast<std::uint64_t>(wanted) == std::bit_cast<std::uint64_t>(value);
  return wanted == value;
}

static bool may_stand_for(char letter, Node const &node) {
  switch (letter) {
  case 'k': return node.is_constant();
  case 'p': return node.attribute == Attribute::parametric;
  default: return true;
  }
}

// Patterns are at most two operations deep, so the rule table bounds the recursion, not the graph.
static bool match_term(Term const &term, FloatingPoint mode, NodeId id, NodeTable const &table, Bindings &bindings) {
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
static bool may_match(Term const &term, Node const &node) {
  switch (term.kind) {
  case Term::Kind::number: return node.is_constant();
  case Term::Kind::variable: return may_stand_for(term.variable, node);
  case Term::Kind::operation: break;
  }
  return node.op == term.op;
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

} // namespace symreal
