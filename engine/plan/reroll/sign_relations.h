// Sign relations: which values are computed negated, in which iterations, chosen for all steps of a function together.
//
// Method: greedy. For each operation, the signs of the result and of the operands are related so that it needs no sign
// factor: in all iterations at once, or not at all if that contradicts earlier relations.
#pragma once

#include "engine/plan/reroll/relative_signs.h"
#include "engine/plan/reroll/signed_body.h"

namespace symreal::reroll {

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
