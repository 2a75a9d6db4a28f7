// Sign relations: which values are computed negated, in which iterations, chosen for all steps of a function together.
//
// Method: greedy. For each operation, the signs of the result and of the operands are related so that it needs no sign
// factor: in all iterations at once, or not at all if that contradicts earlier relations.
#pragma once

#include "engine/plan/loop_function.h"
#include "engine/plan/reroll/relative_signs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace symreal::reroll {

using Pattern = std::vector<char>; // per iteration: whether the sign is flipped

inline bool is_mixed(Pattern const &pattern) {
  return std::ranges::any_of(pattern, [&](char sign) { return sign != pattern.front(); });
}

inline Pattern product(Pattern a, Pattern const &b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] = a[k] != b[k];
  return a;
}

// The body of a step whose values may be negated, per iteration.
class SignedBody {
public:
  SignedBody(LoopStep const &step, std::uint32_t first) : step_(&step), first_(first) {}

  LoopStep const &step() const { return *step_; }
  std::uint32_t count() const { return step_->count; }
  NodeId size() const { return static_cast<NodeId>(step_->body.nodes.size()); }
  Node const &node(NodeId id) const { return step_->body.nodes[id]; }
  // Number of a node's value in an iteration, unique across bodies: from `first` on, up to `end`.
  std::uint32_t value(std::uint32_t iteration, NodeId id) const { return first_ + iteration * size() + id; }
  // Number of a stored value; in a step without a loop distinct from the node's, so that a store may negate it.
  std::uint32_t stored(std::uint32_t iteration, std::size_t store) const {
    if (count() > 1) return value(iteration, step_->stores[store].value);
    return value(1, 0) + static_cast<std::uint32_t>(store);
  }
  std::uint32_t end() const {
    return value(count(), 0) + (count() > 1 ? 0 : static_cast<std::uint32_t>(step_->stores.size()));
  }
  Leaf const *leaf(NodeId id) const { return node(id).op == Op::input ? &step_->leaves[node(id).slot()] : nullptr; }

  Pattern plain() const { return Pattern(count(), 0); }

  // Whether the node is a literal or a table entry, which can take either sign.
  bool is_number(NodeId id) const {
    Leaf const *const here = leaf(id);
    return node(id).is_constant() || (here && here->array == Array::values);
  }
  double number(NodeId id, std::uint32_t iteration) const {
    if (node(id).is_constant()) return node(id).value();
    return value_at(*leaf(id), iteration, step_->nest);
  }
  Pattern signs_of_numbers(NodeId id) const {
    Pattern pattern(count());
    for (std::uint32_t k = 0; k < count(); ++k) pattern[k] = std::signbit(number(id, k));
    return pattern;
  }
  bool is_unit(NodeId id) const {
    for (std::uint32_t k = 0; k < count(); ++k)
      if (std::fabs(number(id, k)) != 1) return false;
    return true;
  }
  // Index of the operand beside the number in a product or quotient with one number; else nullopt.
  std::optional<unsigned> place_beside_number(NodeId id) const {
    Node const &here = node(id);
    if (here.op != Op::mul && here.op != Op::div) return {};
    if (is_number(here.operand[1])) return is_number(here.operand[0]) ? std::optional<unsigned>{} : 0;
    return is_number(here.operand[0]) ? std::optional<unsigned>{1} : std::nullopt;
  }

private:
  LoopStep const *step_;
  std::uint32_t first_;
};

class SignRelations {
public:
  // `bodies`: the steps' bodies in order, which must outlive this object; `memory`: number of its elements.
  SignRelations(std::vector<SignedBody> const &bodies, std::size_t memory);

  // Iterations in which the node is negated.
  Pattern of(SignedBody const &body, NodeId id) const;
  // Iterations in which the stored value is negated.
  Pattern of_store(SignedBody const &body, std::size_t store) const;

private:
  bool is_known(SignedBody const &body, NodeId id);
  bool is_uniform(SignedBody const &body, NodeId id);
  template <class Relate> bool in_all_iterations(SignedBody const &body, Relate const &relate);
  bool relate(SignedBody const &body, NodeId a, NodeId b, Pattern const &are_opposite, bool opposite = false);
  void fix(SignedBody const &body, NodeId id);
  void relate_leaves(std::size_t memory);
  void relate_operations(bool in_loops);
  void relate_numbers(bool in_loops);
  void relate_operation(SignedBody const &body, NodeId id);
  void relate_sum(SignedBody const &body, NodeId id);
  void relate_product(SignedBody const &body, NodeId id);
  void relate_product_with_numbers(SignedBody const &body, NodeId id, bool are_units);

  std::vector<SignedBody> const &bodies_;
  RelativeSigns signs_;
  std::vector<char> negative_; // per value
};

} // namespace symreal::reroll
