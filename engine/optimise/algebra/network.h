// Expression graph for algebra: sums, products and quotients of literals, where a literal is a node or its negative, so
// that signs are free and conceal no equality. Other operations are opaque.
//
// Nodes are hash-consed by value numbering at random points (value.h), not by structure: a new node with the value of
// an old one, or its negative, is the old one. This finds at once mirrored products, the two halves of a symmetric
// matrix, and s^2 + c^2.
#pragma once

#include "engine/graph/node.h"
#include "engine/optimise/algebra/context.h"
#include "engine/optimise/algebra/value.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace symreal::algebra {

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
struct Function {
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
  Literal function(Function function);
  // Copies a node of another network; `now` maps its operands.
  template <class Map> Literal copy(Network const &from, NetworkNode node, Map const &now);

  std::size_t size() const { return nodes_.size(); }
  NetworkNode const &operator[](Index node) const { return nodes_[node]; }
  NetworkNode const &operator[](Literal literal) const { return nodes_[literal.node()]; }
  Function const &function_of(NetworkNode const &node) const { return functions_[node.a.bits]; }
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
  std::vector<Function> functions_;
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

template <class Map> Literal Network::copy(Network const &from, NetworkNode node, Map const &now) {
  switch (node.kind) {
  case Kind::constant: return constant(node.value);
  case Kind::leaf: return leaf(node.a.bits, node.attribute, node.hazards, node.value);
  case Kind::sum: return sum(now(node.a), now(node.b));
  case Kind::product: return product(now(node.a), now(node.b));
  case Kind::quotient: return quotient(now(node.a), now(node.b));
  case Kind::function: break;
  }
  Function made = from.function_of(node);
  for (std::size_t i = 0; i < made.arity; ++i) made.operands[i] = now(made.operands[i]);
  return function(made);
}

} // namespace symreal::algebra
