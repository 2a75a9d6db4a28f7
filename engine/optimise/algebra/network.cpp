#include "engine/optimise/algebra/network.h"

#include <algorithm>
#include <utility>

namespace symreal::algebra {

Network::Network(std::shared_ptr<Context> context) : places_(64, no_index), context_(std::move(context)) {
  constant(0.0);
  constant(1.0);
}

Value Network::value(Literal literal) const {
  Value const &value = nodes_[literal.node()].value;
  return literal.is_negative() ? -value : value;
}

// Slot of the key in the hash table.
std::size_t Network::place_of(std::uint64_t key) const {
  std::size_t const mask = places_.size() - 1;
  std::size_t place = mixed(key) & mask;
  while (places_[place] != no_index && nodes_[places_[place]].value.key() != key) place = (place + 1) & mask;
  return place;
}

void Network::grow() {
  std::vector<Index> old(2 * places_.size(), no_index);
  old.swap(places_);
  for (Index node : old)
    if (node != no_index) places_[place_of(nodes_[node].value.key())] = node;
}

std::optional<Literal> Network::find(Value const &value) const {
  Index const node = places_[place_of(value.key())];
  if (node == no_index) return std::nullopt;
  Value const &known = nodes_[node].value;
  if (equal_in_field(known, value) && confirmed(known, value, 0)) return Literal::of(node);
  if (equal_in_field(-known, value) && confirmed(-known, value, 0)) return Literal::of(node, true);
  return std::nullopt;
}

// `scale` is the magnitude of the node's operands.
Literal Network::intern(NetworkNode const &node, long double scale) {
  std::size_t const place = place_of(node.value.key());
  Index &known = places_[place];
  auto const made = static_cast<Index>(nodes_.size());
  if (known == no_index) {
    known = made;
    nodes_.push_back(node);
    if (2 * ++used_ > places_.size()) grow();
    return Literal::of(made);
  }
  NetworkNode const &old = nodes_[known];
  for (bool negative : {false, true}) {
    Value const value = negative ? -old.value : old.value;
    if (!equal_in_field(value, node.value) || !confirmed(value, node.value, scale)) continue;
    if (old.attribute <= node.attribute && hazards().is_subset(old.hazards, node.hazards))
      return Literal::of(known, negative);
    // From now on lookups find the node that is cheaper or has fewer hazards.
    if (node.attribute <= old.attribute && hazards().is_subset(node.hazards, old.hazards)) known = made;
    break;
  }
  nodes_.push_back(node);
  return Literal::of(made);
}

Literal Network::constant(double value) {
  Literal const positive = constant(value_of(std::fabs(value)));
  return positive.negated_if(value < 0);
}

Literal Network::constant(Value const &value) {
  bool const negative = value.number[0] < 0;
  NetworkNode const node = {Kind::constant, Attribute::constant, no_hazard, {}, {}, negative ? -value : value};
  return intern(node, 0).negated_if(negative);
}

Literal Network::leaf(std::uint32_t tag, Attribute attribute, HazardSet hazards, Value const &value) {
  return intern({Kind::leaf, attribute, hazards, {tag}, {}, value}, 0);
}

Literal Network::sum(Literal a, Literal b) {
  if (a == zero()) return b;
  if (b == zero()) return a;
  if (a == -b) return zero();
  if (a == b) return product(constant(2.0), a);
  if (a.bits > b.bits) std::swap(a, b);
  bool const negative = a.is_negative();
  a = a.negated_if(negative), b = b.negated_if(negative);
  NetworkNode const &x = (*this)[a], &y = (*this)[b];
  NetworkNode const node = {
      Kind::sum, std::max(x.attribute, y.attribute), hazards().unite(x.hazards, y.hazards), a, b, value(a) + value(b)};
  long double const scale = std::fmax(scale_of(x.value), scale_of(y.value));
  if (node.value.is_zero() && confirmed(node.value, value(zero()), scale)) return zero();
  if (node.attribute != Attribute::constant && is_number(node.value)) return constant(node.value).negated_if(negative);
  return intern(node, scale).negated_if(negative);
}

Literal Network::product(Literal a, Literal b) {
  bool const negative = a.is_negative() != b.is_negative();
  a = a.negated_if(a.is_negative()), b = b.negated_if(b.is_negative());
  if (a == zero() || b == zero()) return zero();
  if (a == one()) return b.negated_if(negative);
  if (b == one()) return a.negated_if(negative);
  if (a.bits > b.bits) std::swap(a, b);
  NetworkNode const &x = (*this)[a], &y = (*this)[b];
  NetworkNode const node = {
      Kind::product,    std::max(x.attribute, y.attribute), hazards().unite(x.hazards, y.hazards), a, b,
      x.value * y.value};
  if (node.attribute != Attribute::constant && is_number(node.value)) return constant(node.value).negated_if(negative);
  return intern(node, 0).negated_if(negative);
}

Literal Network::quotient(Literal a, Literal b) {
  bool const negative = a.is_negative() != b.is_negative();
  a = a.negated_if(a.is_negative()), b = b.negated_if(b.is_negative());
  if (a == zero()) return zero();
  if (b == one()) return a.negated_if(negative);
  if (a == b) return one().negated_if(negative);
  NetworkNode const &x = (*this)[a], &y = (*this)[b];
  // Division by a number or parameter becomes multiplication by its inverse, which is free.
  if (y.is_free() && a != one()) return product(a, quotient(one(), b)).negated_if(negative);
  HazardSet const division = y.kind == Kind::constant ? no_hazard : hazards().of_operation(y.value.key() << 1);
  NetworkNode const node = {Kind::quotient,
                            std::max(x.attribute, y.attribute),
                            hazards().unite(hazards().unite(x.hazards, y.hazards), division),
                            a,
                            b,
                            x.value * inverse(y.value)};
  return intern(node, 0).negated_if(negative);
}

std::vector<char> live_nodes(Network const &network) {
  std::vector<char> live(network.size(), 0);
  for (Literal root : network.roots) live[root.node()] = 1;
  for (auto node = static_cast<Index>(network.size()); node-- > 0;)
    if (live[node]) network.for_each_operand(network[node], [&](Literal operand) { live[operand.node()] = 1; });
  return live;
}

std::size_t cost_of(Network const &network) {
  std::vector<char> const live = live_nodes(network);
  std::size_t cost = 0;
  for (Index node = 0; node < network.size(); ++node)
    if (live[node]) cost += static_cast<std::size_t>(network.cost(network[node]));
  return cost;
}

Network rebuilt(Network const &network) {
  std::vector<char> const live = live_nodes(network);
  std::vector<Literal> now(network.size());
  auto literal = [&](Literal old) { return now[old.node()].negated_if(old.is_negative()); };
  Network result(network.context());
  for (Index node = 0; node < network.size(); ++node)
    if (live[node]) now[node] = result.copy(network, network[node], literal);
  for (Literal root : network.roots) result.roots.push_back(literal(root));
  return result;
}

} // namespace symreal::algebra
