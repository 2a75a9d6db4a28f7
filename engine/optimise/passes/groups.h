// Sums and products of several terms, whatever the parentheses between them.
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

// What a tree of additions and subtractions, or of multiplications, adds or multiplies: all that has no other user
// within it, changes of sign included; what is exact, and what depends on no input, is a term. In the order in which it
// is written.
struct Group {
  Op op;      // add or mul
  NodeId end; // of the graph: the sum or product
  std::vector<SignedNode> terms;
};

// The sum, difference or product of two as one operation; what it leaves of the sign is that of the result.
SignedNode combined(Op op, SignedNode a, SignedNode b, NodeTable &table);

// The graph in which each group, its terms in terms of `table`, is what `build` makes of it; where that is nothing it
// stays as it is.
using BuildGroup = std::function<std::optional<SignedNode>(Group const &group, NodeTable &table)>;
Graph regrouped(Graph const &graph, BuildGroup const &build);

} // namespace symreal
