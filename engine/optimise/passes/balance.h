// Sums and products of several terms, put together so that none waits for another one needlessly.
#pragma once

#include "engine/ops/cost_model.h"
#include "engine/optimise/passes/groups.h"

namespace symreal {

class Balance {
public:
  // When a leaf is there, or what depends on no input; what comes long before all else at -infinity.
  using Begin = std::function<double(Node const &node)>;
  Balance(CostModel const &costs, Begin begin) : costs_(costs), begin_(std::move(begin)) {}

  // What comes long before all else is put together in its order. Of the other terms the two that are there first are
  // put together first, as in Huffman's code: no tree is ready earlier.
  SignedNode operator()(Group const &group, NodeTable &table);

  // When node `id` is there if all begin as early as they can: `nodes` are those of a graph or of a table, always of
  // the same one.
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

// What all operations that depend on inputs cost, and those of the longest path from the inputs to an output.
double work(Graph const &graph, CostModel const &costs);
double span(Graph const &graph, CostModel const &costs);

} // namespace symreal
