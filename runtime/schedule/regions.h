// Under which conditions alone a node is needed.
//
// An arm of a select is needed only where the condition holds, or does not; the second operand of && and || only where
// the first does not settle them. A region is a set of such literals: what all uses of a node have in common. Where one
// of them does not hold the node need not be computed, and must not: it might divide by zero.
//
// For each literal of a region the condition's own region is part of that region, so a condition is known wherever the
// literals around it hold. Regions are hash consed: equal ones have one id. Of a region that grows long a gate is made,
// a truth value that stands for all its literals, so that blocks nest only so deep and work stays linear.
#pragma once

#include "graph/graph.h"

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

  // The outermost first: in blocks nested like this neighbours have most in common.
  std::vector<Literal> literals(RegionId region) const;
  bool is_gate(NodeId condition) const { return condition >= node_count_; }
  // The literals that a gate stands for.
  RegionId of_gate(NodeId gate) const { return gates_[gate - node_count_]; }
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

  RegionId append(RegionId before, Code last);
  RegionId make(std::vector<Code> const &ascending);
  std::vector<Code> codes(RegionId region) const;
  void open_gates(std::vector<Code> &x, std::vector<Code> &y) const;

  NodeId node_count_;
  std::vector<Entry> entries_ = {{}};
  std::unordered_map<std::uint64_t, RegionId> by_content_, intersections_;
  std::vector<RegionId> gates_;
  std::unordered_map<RegionId, RegionId> gate_region_;
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
