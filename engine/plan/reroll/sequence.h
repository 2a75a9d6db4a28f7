// Sequence: the operations of a function in recording order, which repeats are searched in.
#pragma once

#include "engine/plan/schedule/schedule.h"

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

// Source of a node in a function: a literal, the input, the array that preprocess fills, the sines and cosines at the
// start (schedule/angles.h), or an operation of its own.
enum class Source : std::uint8_t { constant, input, read, sine, cosine, computed };

struct Sequence {
  Graph const *graph;
  std::vector<Operation> operations;
  std::vector<std::uint32_t> position; // per node: position of the operation that computes it, or no_position
  std::vector<std::uint32_t> slot;     // per node: slot in the array that preprocess fills, or no_slot
  std::vector<std::uint32_t> angle;    // per node: index among the sines or cosines, or no_slot

  std::size_t size() const { return operations.size(); }
  bool is_computed(NodeId node) const { return position[node] != no_position; }
  Source source(NodeId node) const {
    if (is_computed(node)) return Source::computed;
    if (slot[node] != no_slot) return Source::read;
    if (angle[node] != no_slot) return graph->nodes[node].op == Op::sin ? Source::sine : Source::cosine;
    return graph->nodes[node].is_constant() ? Source::constant : Source::input;
  }
  // Index of the node in the array that it is read from.
  std::uint32_t element(NodeId node) const {
    switch (source(node)) {
    case Source::read: return slot[node];
    case Source::sine:
    case Source::cosine: return angle[node];
    default: return graph->nodes[node].slot();
    }
  }
};

// Sequence of the operations that `roots` need.
Sequence sequence(Schedule const &plan, bool in_compute, std::vector<NodeId> const &roots);

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
