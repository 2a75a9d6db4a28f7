// Rewrite rules as data (rules.def) and how they match.
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

// All rules in the order of the table, parsed.
std::span<Rule const> rules();

// What the letters of a pattern stand for; no_node where a letter does not occur.
struct Bindings {
  std::array<NodeId, 26> node;
  NodeId &operator[](char letter) { return node[static_cast<std::size_t>(letter - 'a')]; }
};

// Whether the rule applies to `node`, an operation on nodes of `table`. The rule's root operation must be the node's.
bool match(Rule const &rule, Node const &node, NodeTable const &table, Bindings &bindings);

// Whether the condition holds at a value of k; those on x are matters of its node, not of values, and count as true.
bool holds_for_value(Condition condition, double k);

// The canonical order of the operands of a commutative operation: old before young, constants last.
bool is_newer(NodeId a, NodeId b, NodeTable const &table);

} // namespace symreal
