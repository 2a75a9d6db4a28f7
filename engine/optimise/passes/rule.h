// Rewrite rules, read from rules.def, their matching, and the sweep that applies them.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"
#include "engine/ops/floating_point.h"
#include "engine/optimise/passes/term.h"

#include <array>
#include <limits>
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

// Budget of rewrites, after which nodes stay unchanged; serves to bisect for a wrong rewrite.
struct RewriteLimit {
  std::size_t most = std::numeric_limits<std::size_t>::max();
  std::size_t done = 0;
  Rule const *last = nullptr; // rule of the last rewrite; null if constants were folded
  NodeId last_node = no_node; // node that it replaced, in the input graph
};

struct SweepOptions {
  FloatingPoint mode = FloatingPoint::finite;
  unsigned topics = 0;          // bit set of Topic
  bool fold = false;            // evaluate operations on constants, calling the libm of this process
  bool canonical_order = false; // order commutative operands, so that a+b and b+a are one node
  RewriteLimit *limit = nullptr;
};

// One sweep over a graph in topological order: rebuilds each node from its simplified operands, by rule, by folding, or
// unchanged. The result is hash-consed.
Graph sweep(Graph const &graph, SweepOptions const &options);

} // namespace symreal
