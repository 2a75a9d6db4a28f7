// Groups: sums and products of several terms regardless of parentheses.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"

#include <functional>
#include <optional>
#include <vector>

namespace symreal {

struct SignedNode {
  NodeId node;
  bool is_negative = false;
};

// Terms of a maximal tree of additions and subtractions, or of multiplications, in source order. The tree's inner
// nodes, negations included, have a single use; an exact node, or one that depends on no input, is a term.
struct Group {
  Op op;      // add or mul
  NodeId end; // root of the tree in the graph
  std::vector<SignedNode> terms;
};

// Number of uses of each node by live operations and roots.
std::vector<std::uint32_t> use_counts(Graph const &graph);

// Sum, difference or product of two terms as one operation; the result carries the remaining sign.
SignedNode combined(Op op, SignedNode a, SignedNode b, NodeTable &table);

// The graph with each group replaced by the result of `build`, which gets its terms as nodes of `table`. A group stays
// if `build` returns nullopt.
using BuildGroup = std::function<std::optional<SignedNode>(Group const &group, NodeTable &table)>;
Graph regrouped(Graph const &graph, BuildGroup const &build);

} // namespace symreal
