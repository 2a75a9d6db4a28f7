// Balance of sums and products: expression trees of the least depth.
#pragma once

#include "engine/ops/operation.h"
#include "engine/optimise/passes/groups.h"

namespace symreal {

class Balance {
public:
  // Ready time of a leaf or of a node that depends on no input; -infinity if it precedes all others by far.
  using Begin = std::function<double(Node const &node)>;
  Balance(CostModel const &costs, Begin begin) : costs_(costs), begin_(std::move(begin)) {}

  // Terms ready at -infinity combine in source order. The two others that are ready first combine first, as in
  // Huffman's code: no tree is ready earlier.
  SignedNode operator()(Group const &group, NodeTable &table);

  // Earliest ready time of node `id`. `nodes` are those of a graph or of a table, the same one in all calls.
  template <class Nodes> double time_of(NodeId id, Nodes const &nodes) {
    for (auto next = static_cast<NodeId>(times_.size()); next <= id; ++next) times_.push_back(time(nodes[next]));
    return times_[id];
  }

private:
  double time(Node const &node) const;

  CostModel const &costs_;
  Begin begin_;
  std::vector<double> times_; // per node
};

// Cost of the operations on the longest path from the inputs to an output.
double span(Graph const &graph, CostModel const &costs);

} // namespace symreal
