#include "reroll/sign_relations.h"

#include <ranges>
#include <utility>

namespace symreal::reroll {

SignRelations::SignRelations(std::vector<SignedBody> const &bodies, std::size_t memory)
    : bodies_(bodies),
      signs_(bodies.back().end()) {
  relate_leaves(memory);
  for (SignedBody const &body : bodies_)
    for (Store const &store : body.step().stores)
      if (store.is_result && !body.is_number(store.value)) fix(body, store.value, body.plain());
  // Signs that are the same in all iterations cost nothing: so loops choose before what is computed once.
  relate_operations(true);
  relate_numbers(true);
  for (SignedBody const &body : bodies_)
    for (std::size_t s = 0; s < body.step().stores.size(); ++s)
      signs_.relate(body.stored(0, s), body.value(0, body.step().stores[s].value), false);
  relate_operations(false);
  relate_numbers(false);
}

// What is free yet goes by the signs in tables: without them tables repeat early, and more of them are alike.
void SignRelations::relate_numbers(bool in_loops) {
  for (SignedBody const &body : bodies_)
    for (NodeId id = 0; id < body.size() && (body.count() > 1) == in_loops; ++id)
      relate_product_with_numbers(body, id, false);
}

Pattern SignRelations::of(SignedBody const &body, NodeId id) const {
  Pattern pattern(body.count());
  for (std::uint32_t k = 0; k < body.count(); ++k) pattern[k] = is_negative(body.value(k, id));
  return pattern;
}

Pattern SignRelations::of_store(SignedBody const &body, std::size_t store) const {
  Pattern pattern(body.count());
  for (std::uint32_t k = 0; k < body.count(); ++k) pattern[k] = is_negative(body.stored(k, store));
  return pattern;
}

bool SignRelations::is_negative(std::uint32_t value) const {
  return signs_.root(value).negated != (is_ground(value) && signs_.root(ground).negated);
}

// Loops in which the most chains go on come last, and the signs of all of them must agree there: so the last loops
// first. In a body first what leaves no choice: the sign of a product with a known sign is that of the other operand.
void SignRelations::relate_operations(bool in_loops) {
  auto const is_settled = [&](SignedBody const &body, NodeId id) { return is_known(body, id) || is_uniform(body, id); };
  auto const is_forced = [&](SignedBody const &body, Node const &node) {
    return node.op == Op::neg || ((node.op == Op::mul || node.op == Op::div) &&
                                  (is_settled(body, node.operand[0]) || is_settled(body, node.operand[1])));
  };
  for (SignedBody const &body : std::views::reverse(bodies_))
    for (bool const only_forced : {true, false})
      for (NodeId id = 0; id < body.size() && (body.count() > 1) == in_loops; ++id) {
        Node const &node = body.node(id);
        if (!is_leaf(node.op) && (!only_forced || is_forced(body, node))) relate_operation(body, id);
      }
}

// What is read is what was stored there last, or carried on.
void SignRelations::relate_leaves(std::size_t memory) {
  std::vector<std::uint32_t> stored(memory, ground); // per element the value
  for (SignedBody const &body : bodies_)
    for (std::uint32_t k = 0; k < body.count(); ++k) {
      for (NodeId id = 0; id < body.size(); ++id)
        if (is_leaf(body.node(id).op))
          internal_check(signs_.relate(body.value(k, id), source(body, id, k, stored), false));
      for (std::size_t s = 0; s < body.step().stores.size(); ++s)
        if (Store const &store = body.step().stores[s]; !store.is_result)
          stored[store.access.at(k)] = body.stored(k, s);
    }
}

std::uint32_t SignRelations::source(SignedBody const &body, NodeId id, std::uint32_t k,
                                    std::vector<std::uint32_t> const &stored) {
  Leaf const *const leaf = body.leaf(id);
  if (!leaf) return ground;
  if (leaf->kind == Leaf::Kind::carried && k > 0) return body.value(k - 1, leaf->next);
  bool const is_in_memory = leaf->kind == Leaf::Kind::memory || leaf->kind == Leaf::Kind::carried;
  return is_in_memory ? stored[leaf->access.at(k)] : ground;
}

bool SignRelations::is_known(SignedBody const &body, NodeId id) const {
  for (std::uint32_t k = 0; k < body.count(); ++k)
    if (!is_ground(body.value(k, id))) return false;
  return true;
}

// Whether the sign, known or not, is the same in all iterations: that of what is set before a loop.
bool SignRelations::is_uniform(SignedBody const &body, NodeId id) const {
  SignedValue const first = signs_.root(body.value(0, id));
  for (std::uint32_t k = 1; k < body.count(); ++k) {
    SignedValue const other = signs_.root(body.value(k, id));
    if (other.value != first.value || other.negated != first.negated) return false;
  }
  return true;
}

// In all iterations, or in none.
template <class Other> bool SignRelations::relate_to(SignedBody const &body, NodeId id, Other const &other,
                                                     Pattern const &are_opposite, bool opposite) {
  std::size_t const mark = signs_.mark();
  for (std::uint32_t k = 0; k < body.count(); ++k) {
    if (signs_.relate(body.value(k, id), other(k), (are_opposite[k] != 0) != opposite)) continue;
    signs_.undo_to(mark);
    return false;
  }
  return true;
}

bool SignRelations::relate(SignedBody const &body, NodeId a, NodeId b, Pattern const &are_opposite, bool opposite) {
  return relate_to(body, a, [&](std::uint32_t k) { return body.value(k, b); }, are_opposite, opposite);
}

void SignRelations::fix(SignedBody const &body, NodeId id, Pattern const &pattern) {
  relate_to(body, id, [](std::uint32_t) { return ground; }, pattern, false);
}

void SignRelations::relate_operation(SignedBody const &body, NodeId id) {
  Node const &node = body.node(id);
  switch (node.op) {
  case Op::add:
  case Op::sub: return relate_sum(body, id);
  case Op::neg: relate(body, id, node.operand[0], body.plain(), true); return;
  case Op::mul:
  case Op::div:
    if (body.place_beside_number(id)) return relate_product_with_numbers(body, id, true);
    return relate_product(body, id);
  default:
    fix(body, id, body.plain());
    for (unsigned i = 0; i < arity(node.op) && node.op != Op::abs; ++i) fix(body, node.operand[i], body.plain());
  }
}

// First to the operand whose signs are known: those of the other may still be chosen, also for all iterations anew.
void SignRelations::relate_sum(SignedBody const &body, NodeId id) {
  auto [first, second, none] = body.node(id).operand;
  if (is_known(body, second) && !is_known(body, first)) std::swap(first, second);
  if (body.is_number(first)) std::swap(first, second);
  if (body.is_number(first)) return;
  auto const relate_either = [&](NodeId operand) {
    return body.is_number(operand) || relate(body, id, operand, body.plain()) ||
           relate(body, id, operand, body.plain(), true);
  };
  std::size_t const mark = signs_.mark();
  for (bool const opposite : {false, true}) {
    if (relate(body, id, first, body.plain(), opposite) && relate_either(second)) return;
    signs_.undo_to(mark);
  }
  if (!relate_either(first)) relate_either(second);
}

// `are_units`: only products with 1 and -1, which nobody needs then; otherwise only others.
void SignRelations::relate_product_with_numbers(SignedBody const &body, NodeId id, bool are_units) {
  std::optional<unsigned> const place = body.place_beside_number(id);
  if (!place) return;
  NodeId const number = body.node(id).operand[1 - *place], other = body.node(id).operand[*place];
  if (body.is_unit(number) != are_units) return;
  Pattern const signs = body.signs_of_numbers(number);
  if (!relate(body, id, other, signs)) relate(body, id, other, signs, true);
}

// The sign of one operand must be known for that of the other to go into the product.
void SignRelations::relate_product(SignedBody const &body, NodeId id) {
  auto [a, b, none] = body.node(id).operand;
  bool are_related = true;
  for (std::uint32_t k = 0; k < body.count(); ++k)
    are_related = are_related && signs_.root(body.value(k, a)).value == signs_.root(body.value(k, b)).value;
  if (are_related) return fix(body, id, product(of(body, a), of(body, b)));
  for (auto const &[one, other] : {std::pair(a, b), std::pair(b, a)})
    if (is_uniform(body, one)) {
      relate(body, id, other, body.plain());
      return;
    }
  if (is_known(body, b)) std::swap(a, b);
  for (std::uint32_t k = 0; k < body.count(); ++k)
    if (!is_ground(body.value(k, a))) signs_.relate(body.value(k, a), ground, false);
  relate(body, id, b, of(body, a));
}

} // namespace symreal::reroll
