#include "engine/plan/reroll/sign_relations.h"

#include "engine/plan/reroll/roles.h"

#include <ranges>
#include <utility>

namespace symreal::reroll {

static bool passes_no_sign_on(Op op) {
  return !is_leaf(op) && op != Op::add && op != Op::sub && op != Op::neg && op != Op::mul && op != Op::div;
}

SignRelations::SignRelations(std::vector<SignedBody> const &bodies, std::size_t memory)
    : bodies_(bodies),
      signs_(bodies.back().end()) {
  relate_leaves(memory);
  for (SignedBody const &body : bodies_)
    for (Store const &store : body.step().stores)
      if (store.is_result && !body.is_number(store.value)) fix(body, store.value);
  // Arguments and results of functions keep their signs. Related later, they would need factors; earlier relations may
  // still flip all links of a chain.
  for (SignedBody const &body : bodies_)
    for (NodeId id = 0; id < body.size(); ++id)
      if (passes_no_sign_on(body.node(id).op)) relate_operation(body, id);
  // Signs that are uniform over iterations are free, so loops choose before straight-line code.
  relate_operations(true);
  relate_numbers(true);
  for (SignedBody const &body : bodies_)
    for (std::size_t s = 0; s < body.step().stores.size(); ++s)
      signs_.relate({body.stored(0, s), body.value(0, body.step().stores[s].value)}, false);
  relate_operations(false);
  relate_numbers(false);
  negative_ = signs_.negatives();
}

Pattern SignRelations::of(SignedBody const &body, NodeId id) const {
  Pattern pattern(body.count());
  for (std::uint32_t k = 0; k < body.count(); ++k) pattern[k] = negative_[body.value(k, id)];
  return pattern;
}

Pattern SignRelations::of_store(SignedBody const &body, std::size_t store) const {
  Pattern pattern(body.count());
  for (std::uint32_t k = 0; k < body.count(); ++k) pattern[k] = negative_[body.stored(k, store)];
  return pattern;
}

// Order: rows of chains first, since they hold most operations and the stages around them follow their signs. Then the
// last loops first, since the loops with the most chains come last and all chains must agree there. In a body,
// operations with a forced sign first (a product with a known sign determines the other operand's); and from stores
// down to reads, since stores have their signs already.
void SignRelations::relate_operations(bool in_loops) {
  auto const is_settled = [&](SignedBody const &body, NodeId id) { return is_known(body, id) || is_uniform(body, id); };
  auto const is_forced = [&](SignedBody const &body, Node const &node) {
    return node.op == Op::neg || ((node.op == Op::mul || node.op == Op::div) &&
                                  (is_settled(body, node.operand[0]) || is_settled(body, node.operand[1])));
  };
  for (bool const in_rows : {true, false})
    for (SignedBody const &body : std::views::reverse(bodies_)) {
      if ((body.count() > 1) != in_loops || body.step().nest.has_value() != in_rows) continue;
      for (bool const only_forced : {true, false})
        for (NodeId id = body.size(); id-- > 0;) {
          Node const &node = body.node(id);
          if (!is_leaf(node.op) && (!only_forced || is_forced(body, node))) relate_operation(body, id);
        }
    }
}

// Free values leave table entries unchanged, unless an earlier table has the same entries without their signs.
void SignRelations::relate_numbers(bool in_loops) {
  for (SignedBody const &body : bodies_)
    for (NodeId id = 0; id < body.size() && (body.count() > 1) == in_loops; ++id)
      relate_product_with_numbers(body, id, false);
}

// Relates a read value to the last value stored there, or carried; other leaves are given.
void SignRelations::relate_leaves(std::size_t memory) {
  std::vector<std::optional<std::uint32_t>> stored(memory); // last value stored, per element
  auto const source = [&](SignedBody const &body, NodeId id, std::uint32_t k) -> std::optional<std::uint32_t> {
    Leaf const *const leaf = body.leaf(id);
    if (!leaf) return {};
    if (leaf->is_carried && k > 0) return body.value(k - 1, leaf->next);
    return leaf->array == Array::memory ? stored[leaf->access.at(k)] : std::nullopt;
  };
  for (SignedBody const &body : bodies_)
    for (std::uint32_t k = 0; k < body.count(); ++k) {
      for (NodeId id = 0; id < body.size(); ++id) {
        if (!is_leaf(body.node(id).op)) continue;
        std::optional<std::uint32_t> const from = source(body, id, k);
        internal_check(from ? signs_.relate({body.value(k, id), *from}, false)
                            : signs_.relate({body.value(k, id)}, false));
      }
      for (std::size_t s = 0; s < body.step().stores.size(); ++s)
        if (Store const &store = body.step().stores[s]; !store.is_result)
          stored[store.access.at(k)] = body.stored(k, s);
    }
}

bool SignRelations::is_known(SignedBody const &body, NodeId id) {
  for (std::uint32_t k = 0; k < body.count(); ++k)
    if (!signs_.of({body.value(k, id)}).is_known()) return false;
  return true;
}

// Whether the sign, known or not, is uniform over iterations, as is that of a value set before the loop.
bool SignRelations::is_uniform(SignedBody const &body, NodeId id) {
  RelativeSigns::Sign const first = signs_.of({body.value(0, id)});
  for (std::uint32_t k = 1; k < body.count(); ++k)
    if (signs_.of({body.value(k, id)}) != first) return false;
  return !first.is_too_far;
}

// Relates all iterations, or leaves all unrelated.
template <class Relate> bool SignRelations::in_all_iterations(SignedBody const &body, Relate const &relate) {
  std::size_t const mark = signs_.mark();
  for (std::uint32_t k = 0; k < body.count(); ++k) {
    if (relate(k)) continue;
    signs_.undo_to(mark);
    return false;
  }
  return true;
}

bool SignRelations::relate(SignedBody const &body, NodeId a, NodeId b, Pattern const &are_opposite, bool opposite) {
  return in_all_iterations(body, [&](std::uint32_t k) {
    return signs_.relate({body.value(k, a), body.value(k, b)}, (are_opposite[k] != 0) != opposite);
  });
}

void SignRelations::fix(SignedBody const &body, NodeId id) {
  in_all_iterations(body, [&](std::uint32_t k) { return signs_.relate({body.value(k, id)}, false); });
}

void SignRelations::relate_operation(SignedBody const &body, NodeId id) {
  signs_.keep();
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
    fix(body, id);
    for (unsigned i = 0; i < arity(node.op) && node.op != Op::abs; ++i) fix(body, node.operand[i]);
  }
}

// Relates to the operand with known signs first; the other's may still be chosen, even anew for all iterations.
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

static bool repeats_earlier_without_signs(SignedBody const &body, NodeId number) {
  Leaf const *const table = body.leaf(number);
  if (!table) return false;
  std::vector<double> magnitudes; // of one period
  for (double const value : table->values) magnitudes.push_back(std::fabs(value));
  Role const role = role_of_values(magnitudes);
  return (role.constant ? 1 : role.values.size()) < magnitudes.size();
}

// `are_units`: only products with 1 and -1, which become sign flips; else only the other products.
void SignRelations::relate_product_with_numbers(SignedBody const &body, NodeId id, bool are_units) {
  std::optional<unsigned> const place = body.place_beside_number(id);
  if (!place) return;
  NodeId const number = body.node(id).operand[1 - *place], other = body.node(id).operand[*place];
  if (body.is_unit(number) != are_units) return;
  Pattern const signs =
      are_units || repeats_earlier_without_signs(body, number) ? body.signs_of_numbers(number) : body.plain();
  if (!relate(body, id, other, signs)) relate(body, id, other, signs, true);
}

void SignRelations::relate_product(SignedBody const &body, NodeId id) {
  NodeId const a = body.node(id).operand[0], b = body.node(id).operand[1];
  for (bool const opposite : {false, true})
    if (in_all_iterations(body, [&](std::uint32_t k) {
          return signs_.relate({body.value(k, id), body.value(k, a), body.value(k, b)}, opposite);
        }))
      return;
}

} // namespace symreal::reroll
