// Under which conditions alone a node is needed.
//
// An arm of a select is needed only where the condition holds, or does not; the second operand of && and || only where
// the first does not settle them. A region is a set of such literals: of one use of a node, or what all its uses have
// in common. Where one of them does not hold the node need not be computed, and must not: it might divide by zero.
//
// For each literal of a region the condition's own region is part of that region, so a condition is known wherever the
// literals around it hold. Regions are hash consed: equal ones have one id. Gates are truth values made for two
// reasons:
//   - a region grows long: 1 where all its literals hold, so that blocks nest only so deep and work stays linear
//   - a node is needed here or there: 1 where one of the regions of its uses is
#pragma once

#include "engine/graph/graph.h"

#include <map>
#include <unordered_map>
#include <vector>

namespace symreal {

struct Literal {
  NodeId condition; // a node, or a gate: node count + its number
  bool holds;

  bool operator==(Literal const &) const = default;
};

using RegionId = std::uint32_t;
inline constexpr RegionId everywhere = 0; // no literals

class Regions {
public:
  explicit Regions(std::size_t node_count) : node_count_(static_cast<NodeId>(node_count)) {}

  RegionId with(RegionId region, Literal literal);
  RegionId intersection(RegionId a, RegionId b);
  RegionId united(RegionId a, RegionId b);
  // Whether every literal of `part` is one of `whole`.
  bool contains(RegionId whole, RegionId part) const;
  // The region, or that of its gate where it has become long.
  RegionId shortened(RegionId region);
  // Adds a region to those of a node's uses, and leaves out what others cover.
  void add_use(std::vector<RegionId> &uses, RegionId region);
  // Where one of the uses is. `common`: what they have in common.
  RegionId either(RegionId common, std::vector<RegionId> const &uses);

  // The outermost first: in blocks nested like this neighbours have most in common.
  std::vector<Literal> literals(RegionId region) const;
  bool is_gate(NodeId condition) const { return condition >= node_count_; }
  // Where a gate is computed; that of a long region is 1 there.
  RegionId of_gate(NodeId gate) const { return gate_at(gate).region; }
  // Of these one must hold for the gate to be 1; none for the gate of a long region.
  std::vector<RegionId> const &alternatives(NodeId gate) const { return gate_at(gate).alternatives; }
  // From now on a gate of alternatives counts as 1 and is no literal of any region.
  void release(NodeId gate) { gates_[gate - node_count_].released = true; }
  // Nodes and gates together.
  std::size_t value_count() const { return node_count_ + gates_.size(); }

private:
  // A set in ascending order is its last element after the set of the others.
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
  std::unordered_map<NodeId, std::uint32_t> depth_; // of a condition: how many literals stand around it at least
};

// Where the nodes of a function are computed.
struct Placement {
  Regions regions;
  std::vector<RegionId> of_node;

  bool conditional() const { return !of_node.empty(); } // otherwise every node is computed everywhere
};

// `is_needed`: the nodes of the function; `is_read`: those that it finds in an array. Cheap operations that raise no
// floating-point exception (flag QUIET) may be placed further out than they are needed.
Placement place(Graph const &graph, std::vector<NodeId> const &roots, std::vector<char> const &is_needed,
                std::vector<char> const &is_read);

} // namespace symreal
