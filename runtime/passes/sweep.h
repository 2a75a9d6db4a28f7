// One sweep over a graph in topological order: every node is made anew from its simplified operands, by rule, by
// folding, or as it was. The result is hash consed.
#pragma once

#include "graph/graph.h"
#include "passes/rule.h"

namespace symreal {

struct SweepOptions {
  FloatingPoint mode = FloatingPoint::finite;
  unsigned topics = 0;          // a union of Topic
  bool fold = false;            // evaluate operations on constants, functions with the libm of this process
  bool canonical_order = false; // operands of commutative operations in one order, so that a+b and b+a are one node
};

Graph sweep(Graph const &graph, SweepOptions const &options);

} // namespace symreal
