// Rewrite rules, read from rules.def, and their matching.
#pragma once

#include "engine/graph/node_table.h"
#include "engine/ops/floating_point.h"
#include "engine/optimise/passes/term.h"

#include <array>
#include <span>
#include <string_view>

namespace symreal {

enum class Topic : unsigned { identities = 1, signs = 2, algebra = 4 };
enum class Condition { always, k_negative, k_zero, k_nonzero, k_has_exact_inverse, x_newer, x_truth, x_variable };

struct Rule {
  Topic topic;
  FloatingPoint mode;
  std::string_view pattern_text, replacement_text, counterexample;
  Condition condition;
  Term pattern, replacement;
};

// All rules, parsed, in table order.
std::span<Rule const> rules();

// Nodes bound to the letters of a pattern; no_node if the pattern does not use the letter.
struct Bindings {
  std::array<NodeId, 26> node;
  NodeId &operator[](char letter) { return node[static_cast<std::size_t>(letter - 'a')]; }
};

// Whether the rule applies to `node`, an operation on nodes of `table`. The root operations must be equal.
bool match(Rule const &rule, Node const &node, NodeTable const &table, Bindings &bindings);

// Whether the condition holds for the value k; conditions on x constrain its node, not a value, and count as true.
bool holds_for_value(Condition condition, double k);

// Canonical operand order of a commutative operation: older nodes first, constants last.
bool is_newer(NodeId a, NodeId b, NodeTable const &table);

} // namespace symreal
