// The laws of rewriting at the head of rules.def hold for every row: no rule makes a program dearer, and rules come to
// an end, whatever the order in which they are applied.
#include "engine/optimise/passes/rule.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>

namespace symreal {
namespace {

bool is_free(Term const &term) {
  if (term.kind == Term::Kind::variable) return term.variable == 'k' || term.variable == 'p';
  return std::ranges::all_of(term.operands, is_free);
}

// What a term has to compute, by the costs of its operations. Those on constants alone are folded, those on parameters
// are done by preprocess.
int cost(Term const &term) {
  if (is_free(term) || term.kind == Term::Kind::variable) return 0;
  int sum = info(term.op).cost;
  for (Term const &operand : term.operands) sum += cost(operand);
  return sum;
}

// The operations under the root of a pattern may have other users, so what is saved for certain is the root alone.
bool is_dearer(Rule const &rule) { return cost(rule.replacement) > info(rule.pattern.op).cost; }

std::string letters_of(Term const &term) {
  if (term.kind == Term::Kind::variable) return {term.variable};
  std::string letters;
  for (Term const &operand : term.operands)
    for (char letter : letters_of(operand))
      if (letters.find(letter) == std::string::npos) letters += letter;
  return letters;
}

// All ways to apply one rule at one place, followed to their ends.
class Rewriting {
public:
  explicit Rewriting(std::span<Rule const> rules) : rules_(rules) {}

  // Starts from both sides of a rule, with leaves and small expressions for its letters. What does not end, or comes
  // back, is told; the text is empty where there is none.
  std::string follow(Rule const &rule) {
    std::string const letters = letters_of(rule.pattern);
    std::vector<NodeId> const any = some_nodes(), constants = some_constants(), truths = some_truths(),
                              parametric = some_parametric();
    std::vector<std::vector<NodeId> const *> choices;
    for (char letter : letters)
      choices.push_back(letter == 'k'                                           ? &constants
                        : letter == 'p'                                         ? &parametric
                        : letter == 'x' && rule.condition == Condition::x_truth ? &truths
                                                                                : &any);
    for (std::vector<std::size_t> at(letters.size(), 0);;) {
      Bindings bindings;
      for (std::size_t i = 0; i < letters.size(); ++i) bindings[letters[i]] = (*choices[i])[at[i]];
      for (Term const *side : {&rule.pattern, &rule.replacement})
        if (!ends(build(*side, bindings), 0)) return complaint_;
      std::size_t i = 0;
      while (i < at.size() && ++at[i] == choices[i]->size()) at[i++] = 0;
      if (i == at.size()) return "";
    }
  }

  std::size_t terms() const { return state_.size(); }

private:
  enum class State { open, closed };
  static constexpr int most_steps = 60;

  NodeId make(Op op, std::array<NodeId, 3> operand) {
    return table_.intern(table_.operation(op, operand[0], operand[1], operand[2]));
  }

  std::vector<NodeId> some_constants() {
    std::vector<NodeId> nodes;
    for (double value : {0.0, -0.0, 1.0, -1.0, 2.0, 0.5, -2.0, 3.0, -0.3}) nodes.push_back(table_.constant(value));
    return nodes;
  }
  // Inputs older and younger than one another, constants, and what other rules look for.
  std::vector<NodeId> some_nodes() {
    std::vector<NodeId> nodes;
    for (NodeId index : {0, 1}) nodes.push_back(table_.intern(Node::input(index)));
    nodes.push_back(make(Op::neg, {nodes[0], no_node, no_node}));
    nodes.push_back(make(Op::sub, {nodes[1], nodes[0], no_node}));
    nodes.push_back(make(Op::mul, {nodes[0], nodes[1], no_node}));
    for (double value : {0.0, 1.0, -2.0}) nodes.push_back(table_.constant(value));
    return nodes;
  }
  std::vector<NodeId> some_parametric() {
    NodeId const first = table_.intern(Node::parameter(0)), second = table_.intern(Node::parameter(1));
    return {first, make(Op::neg, {first, no_node, no_node}), make(Op::div, {first, second, no_node})};
  }
  std::vector<NodeId> some_truths() {
    NodeId const first = table_.intern(Node::input(0)), second = table_.intern(Node::input(1));
    NodeId const less = make(Op::lt, {first, second, no_node});
    return {less, make(Op::eq, {first, second, no_node}), make(Op::logical_not, {less, no_node, no_node})};
  }

  bool is_folded(Node const &node) const {
    for (NodeId operand : node.operand)
      if (operand != no_node && !table_[operand].is_constant()) return false;
    return !is_leaf(node.op);
  }
  NodeId fold(Node const &node) {
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < arity(node.op); ++i) values[i] = table_[node.operand[i]].value();
    return table_.constant(evaluate(node.op, values[0], values[1], values[2]));
  }

  NodeId build(Term const &term, Bindings &bindings) {
    switch (term.kind) {
    case Term::Kind::variable: return bindings[term.variable];
    case Term::Kind::number: return table_.constant(term.number);
    case Term::Kind::operation: break;
    }
    std::array<NodeId, 3> operand = {no_node, no_node, no_node};
    for (std::size_t i = 0; i < term.operands.size(); ++i) operand[i] = build(term.operands[i], bindings);
    Node const node = table_.operation(term.op, operand[0], operand[1], operand[2]);
    return is_folded(node) ? fold(node) : table_.intern(node);
  }

  // What one step makes of a node: at its root, or in one operand.
  std::vector<std::pair<NodeId, std::string_view>> steps(NodeId id) {
    Node const node = table_[id];
    std::vector<std::pair<NodeId, std::string_view>> results;
    if (is_leaf(node.op)) return results;
    if (is_folded(node)) return {{fold(node), "folded"}};
    for (Rule const &rule : rules_) {
      Bindings bindings;
      if (rule.pattern.op == node.op && match(rule, node, table_, bindings))
        results.emplace_back(build(rule.replacement, bindings), rule.pattern_text);
    }
    if (info(node.op).has(flag::COMMUTATIVE) && is_newer(node.operand[0], node.operand[1], table_))
      results.emplace_back(make(node.op, {node.operand[1], node.operand[0], no_node}), "exchanged");
    for (std::size_t i = 0; i < arity(node.op); ++i)
      for (auto const &[operand, how] : steps(node.operand[i])) {
        std::array<NodeId, 3> operands = node.operand;
        operands[i] = operand;
        results.emplace_back(make(node.op, operands), how);
      }
    return results;
  }

  bool ends(NodeId id, int taken) {
    auto const [state, is_new] = state_.emplace(id, State::open);
    if (!is_new && state->second == State::closed) return true;
    if (!is_new || taken == most_steps) {
      complaint_ = is_new ? "does not end" : "comes back";
      return false;
    }
    bool good = true;
    for (auto const &[next, how] : steps(id)) {
      good = ends(next, taken + 1);
      if (good) continue;
      complaint_ += " < " + std::string(how);
      break;
    }
    state_[id] = State::closed; // a circle is told once
    return good;
  }

  std::span<Rule const> rules_;
  NodeTable table_;
  std::map<NodeId, State> state_;
  std::string complaint_;
};

Rule rule_of(std::string_view pattern, std::string_view replacement, Condition condition = Condition::always) {
  return {Topic::algebra,      FloatingPoint::fast,    pattern, replacement, "", condition,
          parse_term(pattern), parse_term(replacement)};
}

TEST(RuleLaws, NoRuleIsDearer) {
  for (Rule const &rule : rules())
    EXPECT_FALSE(is_dearer(rule)) << rule.pattern_text << " -> " << rule.replacement_text;
}

TEST(RuleLaws, NoRuleUndoesAnother) {
  Rewriting rewriting(rules());
  for (Rule const &rule : rules()) EXPECT_EQ(rewriting.follow(rule), "") << rule.pattern_text;
  EXPECT_GT(rewriting.terms(), 1000u);
}

// What breaks a law is found.
TEST(RuleLaws, DearerRulesAreFound) {
  EXPECT_TRUE(is_dearer(rule_of("(mul x 2)", "(add (add x x) 0)")));
  EXPECT_TRUE(is_dearer(rule_of("(add (mul x z) (mul y z))", "(mul (add x y) z)")))
      << "the products may have other users";
  EXPECT_FALSE(is_dearer(rule_of("(div x k)", "(mul x (div 1 k))"))) << "the inverse is folded";
}

TEST(RuleLaws, CirclesAreFound) {
  std::vector<Rule> const alone = {rule_of("(sub x y)", "(neg (sub y x))")};
  EXPECT_NE(Rewriting(alone).follow(alone[0]), "");
  std::vector<Rule> const two = {rule_of("(add x (neg y))", "(sub x y)"), rule_of("(sub x y)", "(add x (neg y))")};
  EXPECT_NE(Rewriting(two).follow(two[0]), "");
  std::vector<Rule> const growing = {rule_of("(mul x 2)", "(mul (mul x 1) 2)")};
  EXPECT_NE(Rewriting(growing).follow(growing[0]), "");
}

} // namespace
} // namespace symreal
