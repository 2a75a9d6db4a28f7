// Regions: the conditions under which a node is needed.
//
// An arm of a select is needed only if the condition selects it; the second operand of && and || only if the first
// leaves the value open. A region is a set of such literals: of one use of a node, or the intersection over all its
// uses. If a literal does not hold, the node need not be computed, and must not be: it might divide by zero.
//
// A region includes the region of each of its conditions, so a condition is known wherever the literals around it hold.
// Regions are hash-consed: equal ones have one id. Gates are truth values that replace:
//   - a long region: 1 where all its literals hold, so that the depth of blocks is bounded and work stays linear
//   - alternatives, for a node with uses in different regions: 1 where one of these regions holds
#pragma once

#include "engine/plan/plan.h"

#include <map>
#include <unordered_map>
#include <vector>

namespace symreal {

class Regions {
public:
  explicit Regions(std::size_t node_count) : node_count_(static_cast<NodeId>(node_count)) {}

  RegionId with(RegionId region, Literal literal);
  RegionId intersection(RegionId a, RegionId b);
  RegionId united(RegionId a, RegionId b);
  // Whether the literals of `whole` include those of `part`.
  bool contains(RegionId whole, RegionId part) const;
  // The region itself; the region of its gate if it is too long.
  RegionId shortened(RegionId region);
  // Adds a region to those of a node's uses and removes covered ones.
  void add_use(std::vector<RegionId> &uses, RegionId region);
  // Region in which at least one use is. `common`: intersection of the uses.
  RegionId either(RegionId common, std::vector<RegionId> const &uses);

  // Literals with the outermost first, in the order in which neighbours share the most blocks.
  std::vector<Literal> literals(RegionId region) const;
  bool is_gate(NodeId condition) const { return condition >= node_count_; }
  // Region in which a gate is computed; the gate of a long region is 1 throughout.
  RegionId of_gate(NodeId gate) const { return gate_at(gate).region; }
  // Regions one of which must hold for the gate to be 1; empty for the gate of a long region.
  std::vector<RegionId> const &alternatives(NodeId gate) const { return gate_at(gate).alternatives; }
  // Releases a gate of alternatives: it then counts as 1 and is dropped from all regions.
  void release(NodeId gate) { gates_[gate - node_count_].released = true; }
  // Number of nodes and gates.
  std::size_t value_count() const { return node_count_ + gates_.size(); }

private:
  // An entry extends the set `before` by the greatest code `last`.
  using Code = std::uint32_t; // of a literal: twice the condition, plus one if it holds
  struct Entry {
    RegionId before = everywhere;
    Code last = 0;
    std::uint32_t size = 0;
  };

  struct Gate {
    RegionId region;
    std::vector<RegionId> alternatives = {};
    bool released = false;
  };

  Gate const &gate_at(NodeId gate) const { return gates_[gate - node_count_]; }
  RegionId make_gate(RegionId around, Gate gate);
  RegionId append(RegionId before, Code last);
  RegionId make(std::vector<Code> const &ascending);
  std::vector<Code> codes(RegionId region) const;
  void open_gates(std::vector<Code> &x, std::vector<Code> &y) const;
  bool differ_in_one_outcome(RegionId a, RegionId b, std::vector<Code> &common) const;

  NodeId node_count_;
  std::vector<Entry> entries_ = {{}};
  std::unordered_map<std::uint64_t, RegionId> by_content_, intersections_;
  std::vector<Gate> gates_;
  std::unordered_map<RegionId, RegionId> gate_region_;
  std::map<std::vector<RegionId>, RegionId> alternatives_region_;
  std::unordered_map<NodeId, std::uint32_t> depth_; // of a condition: a lower bound on the number of literals around it
};

// The region of each node of a function.
struct Placement {
  Regions regions;
  std::vector<RegionId> of_node;

  bool conditional() const { return !of_node.empty(); } // false: every node is computed everywhere
};

// `is_needed`: nodes of the function; `is_read`: those that it reads from arrays. Cheap operations that raise no
// floating-point exception (flag QUIET) may be hoisted out of their region.
Placement place(Graph const &graph, std::vector<NodeId> const &roots, std::vector<char> const &is_needed,
                std::vector<char> const &is_read);

// Table of the regions of these statements and of the alternatives of gates; renumbers the ids in `region`.
RegionTable tabulate(Regions const &regions, std::size_t node_count, std::vector<RegionId> &region);

} // namespace symreal
