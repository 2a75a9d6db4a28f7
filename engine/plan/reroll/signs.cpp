#include "engine/plan/reroll/signs.h"

#include "engine/plan/reroll/bodies.h"
#include "engine/plan/reroll/roles.h"
#include "engine/plan/reroll/sign_relations.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace symreal::reroll {

namespace {

// A node of the new body, and whether it is the opposite of the related value in all iterations.
struct Now {
  NodeId node = no_node;
  bool negated = false;
};

class SignRewriter {
public:
  SignRewriter(SignedBody const &body, SignRelations const &signs, std::vector<char> positive)
      : body_(body),
        signs_(signs),
        positive_(std::move(positive)),
        builder_(body.step().body),
        now_(body.size()) {}

  std::size_t columns() const { return columns_.size(); }
  LoopStep step() {
    for (NodeId id = 0; id < body_.size(); ++id)
      if (!body_.is_number(id)) now_[id] = body_.leaf(id) ? Now{builder_.leaf(*body_.leaf(id))} : operation(id);
    for (std::size_t s = 0; s < body_.step().stores.size(); ++s) {
      Store const &store = body_.step().stores[s];
      builder_.store(store.is_result ? itself(store.value) : stored(store.value, signs_.of_store(body_, s)),
                     store.is_result, store.access);
    }
    for (NodeId id = 0; id < body_.size(); ++id)
      if (Leaf const *const leaf = body_.leaf(id); leaf && leaf->is_carried)
        builder_.carry(now_[id].node, as_related(leaf->next));
    return builder_.finish(body_.count(), body_.step().nest);
  }

private:
  Now operation(NodeId id) {
    Node const &node = body_.node(id);
    Pattern const pattern = signs_.of(body_, id);
    switch (node.op) {
    case Op::add:
    case Op::sub: return sum(id, pattern);
    case Op::neg:
      if (body_.is_number(node.operand[0])) return numbers(node.operand[0], product(pattern, minus()));
      return with_sign(now_[node.operand[0]].node, product(product(pattern, sign_of(node.operand[0])), minus()));
    case Op::mul:
    case Op::div: return product_of(id, pattern);
    default: {
      std::array<NodeId, 3> operands = {no_node, no_node, no_node};
      for (unsigned i = 0; i < arity(node.op); ++i)
        operands[i] = node.op == Op::abs ? any(node.operand[i]) : itself(node.operand[i]);
      return with_sign(builder_.operation(node.op, operands, id), pattern);
    }
    }
  }

  Now sum(NodeId id, Pattern const &pattern) {
    Node const &node = body_.node(id);
    std::array<Now, 2> terms;
    for (unsigned i = 0; i < 2; ++i) {
      Pattern sign = product(pattern, sign_of(node.operand[i]));
      if (i == 1 && node.op == Op::sub) sign = product(sign, minus());
      terms[i] = body_.is_number(node.operand[i]) ? numbers(node.operand[i], sign)
                                                  : with_sign(now_[node.operand[i]].node, sign);
    }
    if (terms[0].negated && !terms[1].negated) std::swap(terms[0], terms[1]);
    Op const op = terms[0].negated == terms[1].negated ? Op::add : Op::sub;
    return {builder_.operation(op, {terms[0].node, terms[1].node, no_node}, id), terms[0].negated};
  }

  Now product_of(NodeId id, Pattern const &pattern) {
    Node const &node = body_.node(id);
    Pattern const sign = product(product(pattern, sign_of(node.operand[0])), sign_of(node.operand[1]));
    std::optional<unsigned> const place = body_.place_beside_number(id);
    if (!place)
      return with_sign(builder_.operation(node.op, {any(node.operand[0]), any(node.operand[1]), no_node}, id), sign);
    NodeId const number = node.operand[1 - *place], other = any(node.operand[*place]);
    Pattern const of_number = product(sign, body_.signs_of_numbers(number));
    bool const changes_sign_only = body_.is_unit(number) && (node.op == Op::mul || *place == 0);
    if (changes_sign_only && !is_mixed(of_number)) return with_sign(other, of_number);
    Now const factor = numbers(number, sign);
    std::array<NodeId, 3> operands = {no_node, no_node, no_node};
    operands[*place] = other;
    operands[1 - *place] = factor.node;
    return {builder_.operation(node.op, operands, id), factor.negated};
  }

  Pattern minus() const { return Pattern(body_.count(), 1); }

  // Signs of the node that now replaces `id`.
  Pattern sign_of(NodeId id) const {
    if (body_.is_number(id)) return body_.plain();
    return now_[id].negated ? product(signs_.of(body_, id), minus()) : signs_.of(body_, id);
  }
  NodeId any(NodeId id) { return body_.is_number(id) ? plain(numbers(id, body_.plain())) : now_[id].node; }
  NodeId as_related(NodeId id) { return body_.is_number(id) ? any(id) : plain(now_[id]); }
  NodeId itself(NodeId id) { return stored(id, body_.plain()); }
  NodeId stored(NodeId id, Pattern const &pattern) {
    if (body_.is_number(id)) return plain(numbers(id, pattern));
    return plain(with_sign(now_[id].node, product(pattern, sign_of(id))));
  }
  NodeId plain(Now now) {
    return now.negated ? builder_.operation(Op::neg, {now.node, no_node, no_node}, no_node) : now.node;
  }

  Now with_sign(NodeId value, Pattern const &sign) {
    if (!is_mixed(sign)) return {value, sign.front() != 0};
    std::vector<double> factors;
    for (char const negated : sign) factors.push_back(negated ? -1.0 : 1.0);
    Now const factor = column(factors);
    return {builder_.operation(Op::mul, {factor.node, value, no_node}, no_node), factor.negated};
  }

  Now numbers(NodeId id, Pattern const &sign) {
    std::vector<double> values;
    for (std::uint32_t k = 0; k < body_.count(); ++k)
      values.push_back(sign[k] ? -body_.number(id, k) : body_.number(id, k));
    return column(values);
  }

  // A column or its negative; the body has only one of them.
  Now column(std::vector<double> const &values) {
    Role role = role_of_values(values, body_.step().nest);
    if (role.constant) role.values = {*role.constant};
    auto const magnitude = [](double value) { return std::fabs(value); };
    bool const is_negative = *std::ranges::max_element(role.values, {}, magnitude) < 0;
    std::vector<double> positive = role.values;
    for (double &value : positive) value = is_negative ? -value : value;
    std::vector<std::uint64_t> key(1, role.by_turn ? 1 : 0);
    for (double const value : positive) key.push_back(std::bit_cast<std::uint64_t>(value));
    auto const [entry, is_new] = columns_.try_emplace(std::move(key));
    Now &there = entry->second;
    if (is_new) {
      std::size_t const number = columns_.size() - 1;
      there.negated = is_negative && (number >= positive_.size() || !positive_[number]);
      if (!there.negated) role.values = std::move(positive);
      there.node = role.constant ? builder_.constant(role.values.front())
                                 : builder_.leaf({role.array, {}, role.values, role.by_turn});
    }
    return {there.node, there.negated != is_negative};
  }

  SignedBody const &body_;
  SignRelations const &signs_;
  std::vector<char> positive_; // per column, in order of first use
  BodyBuilder builder_;
  std::vector<Now> now_;                              // per node other than numbers
  std::map<std::vector<std::uint64_t>, Now> columns_; // negated: in the body the largest magnitude is negative
};

// Loops share tables with equal entries, so the largest magnitude of a column is made positive where that takes no
// extra operation.
LoopStep with_positive_columns(SignedBody const &body, SignRelations const &signs) {
  constexpr std::size_t most_work = 100'000'000; // columns times their values
  SignRewriter plain(body, signs, {});
  LoopStep best = plain.step();
  std::vector<char> positive(plain.columns(), 1);
  LoopStep all = SignRewriter(body, signs, positive).step();
  if (operations_of(all) <= operations_of(best)) return all;
  if (positive.size() * body.size() * body.count() > most_work) return best;
  std::ranges::fill(positive, 0);
  for (char &column : positive) {
    column = 1;
    LoopStep other = SignRewriter(body, signs, positive).step();
    if (operations_of(other) <= operations_of(best))
      best = std::move(other);
    else
      column = 0;
  }
  return best;
}

std::size_t operations_in(std::vector<LoopStep> const &steps) {
  std::size_t count = 0;
  for (LoopStep const &step : steps) count += operations_of(step);
  return count;
}

} // namespace

LoopFunction with_few_signs(LoopFunction function) {
  std::vector<SignedBody> bodies;
  for (LoopStep const &step : function.steps) bodies.emplace_back(step, bodies.empty() ? 1 : bodies.back().end());
  SignRelations const signs(bodies, function.memory);
  std::vector<LoopStep> steps;
  for (SignedBody const &body : bodies) steps.push_back(with_positive_columns(body, signs));
  if (operations_in(steps) <= operations_in(function.steps)) function.steps = std::move(steps);
  return function;
}

} // namespace symreal::reroll
