// The pool of one thread: the graph that is being recorded, and the carried values of its nodes.
//
// One pool per thread rather than one behind a mutex: kernels recorded by several threads do not meet, and the
// generation in each node tells one pool's nodes from another's.
#pragma once

#include "graph/node_table.h"

#include <symreal/annotate.h>
#include <symreal/symbolic.h>

#include <vector>

namespace symreal::trace {

// Whatever is computed from a missing value is missing, too.
bool is_missing(double value);

class Pool {
public:
  // Constant-initialised, made on first use, never destroyed: numbers with static storage outlive it otherwise.
  static Pool &current();

  // Begins a recording with a generation of its own.
  void begin();
  // Ends it: what is left are the nodes, handed over. Numbers that still hold one are stale from now on.
  std::vector<Node> end();
  bool is_recording() const { return recording_; }

  RealNumber leaf(Node const &node, double value);
  RealNumber record(Op op, RealNumber x, RealNumber y, RealNumber z);

  // The node behind a number; a constant is interned. Leaks and stale nodes end the program with a diagnostic.
  NodeId node(RealNumber number);
  double carried_value(RealNumber number);
  bool owns(RealNumber number) const { return number.is_node() && generation_of(number) == generation_; }
  // What a number becomes when its kernel ends.
  double final_value(RealNumber number) const { return values_[static_cast<NodeId>(number.to_bits())]; }

  NodeTable const &nodes() const { return table_; }

private:
  static std::uint8_t generation_of(RealNumber number) { return static_cast<std::uint8_t>(number.to_bits() >> 32); }
  RealNumber number(NodeId id) const;
  double value_of(Node const &node) const;
  NodeId checked(RealNumber number) const;

  NodeTable table_;
  std::vector<double> values_; // the carried value of each node
  std::uint8_t generation_ = 0;
  bool recording_ = false;
};

} // namespace symreal::trace
