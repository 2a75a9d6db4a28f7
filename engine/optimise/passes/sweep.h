// One sweep over a graph in topological order: rebuilds each node from its simplified operands, by rule, by folding, or
// unchanged. The result is hash-consed.
#pragma once

#include "engine/graph/graph.h"
#include "engine/optimise/passes/rule.h"

#include <limits>

namespace symreal {

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

Graph sweep(Graph const &graph, SweepOptions const &options);

} // namespace symreal
