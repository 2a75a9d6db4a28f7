// Expression graph for algebra: sums, products and quotients of literals, where a literal is a node or its negative, so
// that signs are free and conceal no equality. Other operations are opaque.
//
// Nodes are hash-consed by value numbering at random points (value.h), not by structure: a new node with the value of
// an old one, or its negative, is the old one. This finds at once mirrored products, the two halves of a symmetric
// matrix, and s^2 + c^2.
#pragma once

#include "engine/graph/node.h"
#include "engine/ops/operation.h"
#include "engine/optimise/algebra/value.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace symreal::algebra {

// Hazards: operations and inputs that a replacement must not newly depend on.
//
// A quotient, or a function that is not defined everywhere, may be computed only where the program computes it: behind
// a guard, or in the arm that a select takes. And a value that does not depend on an input must not become the
// difference of two values that do, since rounding destroys it if that input is large. So an expression may replace
// another only if its hazards, such operations and inputs, are a subset of the other's. Equal sets have equal numbers.
using HazardSet = std::uint32_t;
inline constexpr HazardSet no_hazard = 0;

class HazardSets {
public:
  HazardSets() : sets_(1) {}

  // Singleton sets: of an operation, identified by `key`, and of an input.
  HazardSet of_operation(std::uint64_t key) { return number_of(single(element_of(key))); }
  HazardSet of_input(std::uint32_t slot);
  HazardSet inputs_in(HazardSet set);
  HazardSet unite(HazardSet a, HazardSet b);
  // Conservative: true only if `a` is a subset of `b`. A very large union is a subset of itself alone.
  bool is_subset(HazardSet a, HazardSet b) const;

private:
  using Bits = std::vector<std::uint64_t>; // without trailing zeros
  static constexpr std::size_t most_words = 128;

  std::uint32_t element_of(std::uint64_t key);
  static Bits single(std::uint32_t element);
  HazardSet number_of(Bits bits);
  HazardSet too_large();

  std::vector<Bits> sets_; // all but the first: empty if too large
  Bits inputs_;
  std::unordered_map<std::uint64_t, std::uint32_t> elements_;
  std::unordered_multimap<std::uint64_t, HazardSet> numbers_; // keyed by a hash of the bits
  std::unordered_map<std::uint64_t, HazardSet> unions_;
};

// Context that all networks of one graph share.
struct Context {
  explicit Context(CostModel const &costs = usual_costs()) {
    double const other = (costs[Op::add] + costs[Op::mul]) / 2;
    division = other > 0 ? static_cast<int>(std::lround(std::clamp(costs[Op::div] / other, 1.0, 100.0))) : 1;
  }

  int division; // cost of a quotient; sums and products cost 1
  HazardSets hazards;
  Angles angles;
};

using Index = std::uint32_t;
inline constexpr Index no_index = ~Index{0};

struct Literal {
  std::uint32_t bits = 0;

  static Literal of(Index node, bool negative = false) { return {node << 1 | static_cast<std::uint32_t>(negative)}; }
  Index node() const { return bits >> 1; }
  bool is_negative() const { return (bits & 1) != 0; }
  Literal operator-() const { return {bits ^ 1}; }
  Literal negated_if(bool condition) const { return {bits ^ static_cast<std::uint32_t>(condition)}; }
  bool operator==(Literal const &) const = default;
};

enum class Kind : std::uint8_t { constant, leaf, sum, product, quotient, function };

struct NetworkNode {
  Kind kind;
  Attribute attribute; // constant and parametric nodes are free
  HazardSet hazards;
  Literal a, b; // leaf: a.bits is its tag; function: its number
  Value value;

  bool is_free() const { return attribute != Attribute::variable; }
  bool is_arithmetic() const { return kind == Kind::sum || kind == Kind::product || kind == Kind::quotient; }
};

// An operation that is opaque to algebra. A nonzero `origin` makes it distinct from all others, with an arbitrary
// value.
struct OpaqueFunction {
  Op op;
  std::uint32_t arity;
  std::array<Literal, 3> operands;
  std::uint64_t origin = 0;
};

class Network {
public:
  explicit Network(std::shared_ptr<Context> context);

  Literal zero() const { return Literal::of(0); }
  Literal one() const { return Literal::of(1); }
  Literal constant(double value);
  Literal constant(Value const &value);
  Literal leaf(std::uint32_t tag, Attribute attribute, HazardSet hazards, Value const &value);
  Literal sum(Literal a, Literal b);
  Literal product(Literal a, Literal b);
  Literal quotient(Literal a, Literal b);
  Literal function(OpaqueFunction function);
  // Copies a node of another network; `now` maps its operands.
  template <class Map> Literal copy(Network const &from, NetworkNode node, Map const &now);

  std::size_t size() const { return nodes_.size(); }
  NetworkNode const &operator[](Index node) const { return nodes_[node]; }
  NetworkNode const &operator[](Literal literal) const { return nodes_[literal.node()]; }
  OpaqueFunction const &function_of(NetworkNode const &node) const { return functions_[node.a.bits]; }
  std::size_t function_count() const { return functions_.size(); }
  Value value(Literal literal) const;
  // Literal with this value, else nullopt.
  std::optional<Literal> find(Value const &value) const;
  std::shared_ptr<Context> const &context() const { return context_; }
  HazardSets &hazards() const { return context_->hazards; }
  // Functions cost 0, since the search leaves them unchanged.
  int cost(NetworkNode const &node) const {
    return !node.is_arithmetic() || node.is_free() ? 0 : node.kind == Kind::quotient ? context_->division : 1;
  }

  template <class Visit> void for_each_operand(NetworkNode const &node, Visit const &visit) const {
    if (node.is_arithmetic()) {
      visit(node.a);
      visit(node.b);
    } else if (node.kind == Kind::function) {
      for (std::size_t i = 0; i < function_of(node).arity; ++i) visit(function_of(node).operands[i]);
    }
  }

  std::vector<Literal> roots;

private:
  Literal intern(NetworkNode const &node, long double scale);
  void grow();
  std::size_t place_of(std::uint64_t key) const;

  std::vector<NetworkNode> nodes_; // operands before their users
  std::vector<OpaqueFunction> functions_;
  std::vector<Index> places_; // open addressing, keyed by Value::key
  std::size_t used_ = 0;
  std::shared_ptr<Context> context_;
};

// Nodes that the roots depend on.
std::vector<char> live_nodes(Network const &network);
// Cost of the live additions, multiplications and divisions.
std::size_t cost_of(Network const &network);
// Copy of the live nodes.
Network rebuilt(Network const &network);
// Common reciprocals: replaces a / d and b / d by a * (1 / d) and b * (1 / d) if that costs less, one division per
// denominator. The hazards stay the same.
Network with_common_reciprocals(Network const &network);

// Literals of a network that stand for those of another.
class LiteralMap {
public:
  explicit LiteralMap(std::size_t nodes) : now_(nodes) {}

  Literal &operator[](Index node) { return now_[node]; }
  Literal operator[](Index node) const { return now_[node]; }
  Literal operator()(Literal old) const { return now_[old.node()].negated_if(old.is_negative()); }

private:
  std::vector<Literal> now_;
};

// Copy of the live nodes, except that `replacement(node, result, now)` stands for a node if it is not nullopt; `now`
// maps the nodes before it to those of `result`.
template <class Replacement> Network rewritten(Network const &network, Replacement const &replacement) {
  std::vector<char> const live = live_nodes(network);
  LiteralMap now(network.size());
  Network result(network.context());
  for (Index node = 0; node < network.size(); ++node) {
    if (!live[node]) continue;
    std::optional<Literal> const other = replacement(node, result, std::as_const(now));
    now[node] = other ? *other : result.copy(network, network[node], now);
  }
  for (Literal root : network.roots) result.roots.push_back(now(root));
  return result;
}

template <class Map> Literal Network::copy(Network const &from, NetworkNode node, Map const &now) {
  switch (node.kind) {
  case Kind::constant: return constant(node.value);
  case Kind::leaf: return leaf(node.a.bits, node.attribute, node.hazards, node.value);
  case Kind::sum: return sum(now(node.a), now(node.b));
  case Kind::product: return product(now(node.a), now(node.b));
  case Kind::quotient: return quotient(now(node.a), now(node.b));
  case Kind::function: break;
  }
  OpaqueFunction made = from.function_of(node);
  for (std::size_t i = 0; i < made.arity; ++i) made.operands[i] = now(made.operands[i]);
  return function(made);
}

} // namespace symreal::algebra
