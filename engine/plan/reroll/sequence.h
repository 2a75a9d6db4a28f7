// Sequence: the operations of a function in recording order, which repeats are searched in.
#pragma once

#include "engine/plan/plan.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace symreal::reroll {

inline constexpr std::uint32_t no_position = ~std::uint32_t{0};

// An operand; `negated`: the second operand of a difference.
struct Operand {
  NodeId node = no_node;
  bool negated = false;
  bool operator==(Operand const &) const = default;
};

// x - y is bitwise x + (-y), so sums and differences are one kind of operation.
struct Operation {
  NodeId node;
  Op op;
  std::array<Operand, 3> operands = {};
  unsigned count = 0;        // of operands
  bool may_exchange = false; // the first two
};

struct Sequence {
  Graph const *graph;
  std::vector<Operation> operations;
  std::vector<std::uint32_t> position; // per node: position of the operation that computes it, or no_position
  std::vector<std::uint32_t> slot;     // per node: slot in the array that preprocess fills, or no_slot
  std::vector<std::uint32_t> angle;    // per node: index among the sines or cosines, or no_slot

  std::size_t size() const { return operations.size(); }
  bool is_computed(NodeId node) const { return position[node] != no_position; }
  // Array that the node is read from: `memory` if an operation of the sequence computes it, `values` for a literal.
  Array array(NodeId node) const {
    if (is_computed(node)) return Array::memory;
    if (slot[node] != no_slot) return Array::constants;
    Node const &here = graph->nodes[node];
    if (angle[node] != no_slot) return here.op == Op::sin ? Array::sine : Array::cosine;
    return here.is_constant() ? Array::values : here.op == Op::parameter ? Array::parameters : Array::input;
  }
  // Index of the node in an array of other functions.
  std::uint32_t element(NodeId node) const {
    switch (array(node)) {
    case Array::constants: return slot[node];
    case Array::sine:
    case Array::cosine: return angle[node];
    default: return graph->nodes[node].slot();
    }
  }
};

// Sequence of the operations that `roots` need.
Sequence sequence(Plan const &plan, FunctionKind kind, std::vector<NodeId> const &roots);

// A sequence with duplicates of products that several windows share.
//
// Each term of a series multiplies the same variable by a constant. If two terms have the same constant, only the first
// computes the product, and neither resembles the terms around it. With the product computed in both, all terms match.
struct OwnProducts {
  std::unique_ptr<Graph> graph; // has extra nodes at its end, which earlier operations may read
  Sequence sequence;            // of `graph`
};

// Sequence with the duplicated products; nullopt if there are too few of them.
std::optional<OwnProducts> with_own_products(Sequence const &sequence);

} // namespace symreal::reroll
