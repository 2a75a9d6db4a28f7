// One sweep over a graph in topological order: every node is made anew from its simplified operands, by rule, by
// folding, or as it was. The result is hash consed.
#pragma once

#include "engine/graph/graph.h"
#include "engine/optimise/passes/rule.h"

#include <limits>

namespace symreal {

// How far a sweep goes: after so many rewrites nodes stay as they are. For finding the one that is wrong.
struct RewriteLimit {
  std::size_t most = std::numeric_limits<std::size_t>::max();
  std::size_t done = 0;
  Rule const *last = nullptr; // of the last rewrite; none: constants were folded
  NodeId last_node = no_node; // that it was made of, in the graph before the sweep
};

struct SweepOptions {
  FloatingPoint mode = FloatingPoint::finite;
  unsigned topics = 0;          // a union of Topic
  bool fold = false;            // evaluate operations on constants, functions with the libm of this process
  bool canonical_order = false; // operands of commutative operations in one order, so that a+b and b+a are one node
  RewriteLimit *limit = nullptr;
};

Graph sweep(Graph const &graph, SweepOptions const &options);

} // namespace symreal
