#include "engine/optimise/algebra/network.h"

namespace symreal::algebra {

namespace {

enum class Parity : std::uint8_t { none, odd, even };

Parity parity_of(Op op) {
  switch (op) {
  case Op::sin:
  case Op::tan:
  case Op::asin:
  case Op::atan:
  case Op::sinh:
  case Op::tanh:
  case Op::asinh:
  case Op::atanh:
  case Op::erf:
  case Op::cbrt: return Parity::odd;
  case Op::cos:
  case Op::cosh:
  case Op::abs: return Parity::even;
  default: return Parity::none;
  }
}

// Whether the operation is finite for all finite operands. A select shields its arms, so it counts as partial.
bool is_total(Op op) {
  bool const is_exact = op == Op::add || op == Op::sub || op == Op::mul; // exact arithmetic
  return is_exact || op == Op::sin || op == Op::cos ||
         (info(op).has(flag::QUIET) && op != Op::select && op != Op::wide_select);
}

// Pseudorandom value at each point, keyed by the operands' values there.
Value opaque_value(OpaqueFunction const &function, Network const &network) {
  Value result{};
  std::uint64_t all = function.origin;
  for (std::size_t k = 0; k < field_points; ++k) {
    std::uint64_t key = mixed(static_cast<std::uint64_t>(function.op) * 64 + function.arity) + function.origin;
    for (std::size_t i = 0; i < function.arity; ++i) key = mixed(key) + network.value(function.operands[i]).field[k];
    result.field[k] = random_residue(key);
    all = mixed(all) + result.field[k];
  }
  for (std::size_t k = 0; k < number_points; ++k) result.number[k] = random_value(all).number[k];
  return result;
}

} // namespace

std::uint32_t HazardSets::element_of(std::uint64_t key) {
  return elements_.emplace(key, static_cast<std::uint32_t>(elements_.size())).first->second;
}

HazardSets::Bits HazardSets::single(std::uint32_t element) {
  Bits bits(element / 64 + 1, 0);
  bits.back() = std::uint64_t{1} << element % 64;
  return bits;
}

HazardSet HazardSets::of_input(std::uint32_t slot) {
  std::uint32_t const element = element_of(std::uint64_t{1} << 63 | slot);
  inputs_.resize(std::max<std::size_t>(inputs_.size(), element / 64 + 1), 0);
  inputs_[element / 64] |= std::uint64_t{1} << element % 64;
  return number_of(single(element));
}

HazardSet HazardSets::inputs_in(HazardSet set) {
  if (set != no_hazard && sets_[set].empty()) return too_large();
  Bits bits = sets_[set];
  bits.resize(std::min(bits.size(), inputs_.size()));
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] &= inputs_[i];
  while (!bits.empty() && bits.back() == 0) bits.pop_back();
  return bits.empty() ? no_hazard : number_of(std::move(bits));
}

HazardSet HazardSets::too_large() {
  sets_.emplace_back();
  return static_cast<HazardSet>(sets_.size() - 1);
}

HazardSet HazardSets::number_of(Bits bits) {
  if (bits.size() > most_words) return too_large();
  std::uint64_t hash = bits.size();
  for (std::uint64_t word : bits) hash = mixed(hash + word);
  auto const [first, last] = numbers_.equal_range(hash);
  for (auto known = first; known != last; ++known)
    if (sets_[known->second] == bits) return known->second;
  auto const number = static_cast<HazardSet>(sets_.size());
  sets_.push_back(std::move(bits));
  numbers_.emplace(hash, number);
  return number;
}

HazardSet HazardSets::unite(HazardSet a, HazardSet b) {
  if (a == b || b == no_hazard) return a;
  if (a == no_hazard) return b;
  if (a > b) std::swap(a, b);
  auto const [known, is_new] = unions_.emplace(std::uint64_t{a} << 32 | b, no_hazard);
  if (!is_new) return known->second;
  if (sets_[a].empty() || sets_[b].empty()) return known->second = too_large();
  Bits united = sets_[a];
  united.resize(std::max(sets_[a].size(), sets_[b].size()), 0);
  for (std::size_t i = 0; i < sets_[b].size(); ++i) united[i] |= sets_[b][i];
  return known->second = number_of(std::move(united));
}

bool HazardSets::is_subset(HazardSet a, HazardSet b) const {
  if (a == b || a == no_hazard) return true;
  Bits const &small = sets_[a], &large = sets_[b];
  if (small.empty() || small.size() > large.size()) return false;
  for (std::size_t i = 0; i < small.size(); ++i)
    if ((small[i] & ~large[i]) != 0) return false;
  return true;
}

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

Literal Network::function(OpaqueFunction made) {
  bool negative = false;
  if (Parity const parity = parity_of(made.op); parity != Parity::none && made.operands[0].is_negative()) {
    made.operands[0] = -made.operands[0];
    negative = parity == Parity::odd;
  }
  // A function of constants is not folded here.
  Attribute attribute = info(made.op).has(flag::EFFECT) ? Attribute::variable : Attribute::parametric;
  HazardSet rests_on = no_hazard;
  for (std::size_t i = 0; i < made.arity; ++i) {
    NetworkNode const &operand = (*this)[made.operands[i]];
    attribute = std::max(attribute, operand.attribute);
    rests_on = hazards().unite(rests_on, operand.hazards);
  }
  NetworkNode node = {Kind::function, attribute, rests_on, {static_cast<std::uint32_t>(functions_.size())}, {}, {}};
  if (made.op == Op::sin && made.origin == 0)
    node.value = context_->angles.sine(value(made.operands[0]));
  else if (made.op == Op::cos && made.origin == 0)
    node.value = context_->angles.cosine(value(made.operands[0]));
  else
    node.value = opaque_value(made, *this);
  if (!is_total(made.op)) {
    // A partial function shields its operands' hazards except the inputs.
    HazardSet const itself = hazards().of_operation(node.value.key() << 1 | 1);
    node.hazards = hazards().unite(hazards().inputs_in(rests_on), itself);
  }
  functions_.push_back(made);
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
  return rewritten(network, [](auto &&...) { return std::optional<Literal>(); });
}

Network with_common_reciprocals(Network const &network) {
  std::vector<char> const live = live_nodes(network);
  std::vector<std::uint32_t> quotients(network.size(), 0); // indexed by denominator
  auto is_quotient = [&](Index node) { return network[node].kind == Kind::quotient && !network[node].is_free(); };
  for (Index node = 0; node < network.size(); ++node)
    if (live[node] && is_quotient(node)) ++quotients[network[node].b.node()];
  auto is_common = [&](Index denominator) {
    auto const count = static_cast<int>(quotients[denominator]), division = network.context()->division;
    return division + count < count * division;
  };
  return rewritten(network, [&](Index node, Network &result, LiteralMap const &now) -> std::optional<Literal> {
    Literal const a = network[node].a, b = network[node].b;
    if (!is_quotient(node) || !is_common(b.node())) return std::nullopt;
    return result.product(now(a), result.quotient(result.one(), now(b)));
  });
}

} // namespace symreal::algebra
