#include "engine/optimise/algebra/proposals.h"

#include <algorithm>

namespace symreal::algebra {

Proposals::Proposals(MutableNetwork &network, ResubstitutionSettings const &settings, Search &search)
    : network_(network),
      settings_(settings),
      search_(search),
      is_near_(network.size(), 0) {
  for (Index node = 0; node < network_.size(); ++node) add(node);
}

Proposal Proposals::best_for(Index target) {
  target_ = target;
  cone_ = network_.cone_cost(target);
  best_ = {};
  look_around();
  network_.look_for_users(target);
  std::erase_if(near_, [&](Index near) { return network_.needs_it(near); });
  search_.work += 2 * near_.size() + network_.take_far_visits() / 8;
  if (cone_ >= 3) invert_rests();
  for (std::size_t i = 0; i < near_.size(); ++i) {
    try_sum(i);
    try_product(near_[i]);
  }
  try_multiple();
  if (cone_ >= 2) {
    make_pairs();
    for (std::size_t i = 0; i < std::min(near_.size(), settings_.pairs_among); ++i) try_with_pair(near_[i]);
  }
  if (cone_ >= 3) try_two_products();
  return best_;
}

void Proposals::add(Index node) {
  inverse_.push_back(inverse(first(node)));
  Residue const second = network_[node].value.field[1];
  ratio_.push_back(multiply(second, inverse_.back()));
  if (network_[node].is_free() || !network_.is_alive(node)) return;
  if (std::uint32_t &known = by_ratio_[ratio_.back()]; known == KeyTable::none) known = node;
}

// Collects the neighbourhood of the target: its operands and their users, breadth first.
void Proposals::look_around() {
  near_.clear();
  std::vector<Index> open = {target_};
  is_near_.resize(network_.size(), 0);
  is_near_[target_] = 1;
  auto add = [&](Index node) {
    if (is_near_[node] || !network_.is_alive(node) || node == 0) return;
    is_near_[node] = 1;
    open.push_back(node);
    near_.push_back(node);
  };
  constexpr std::size_t most_users = 12;
  for (std::size_t next = 0; next < open.size() && near_.size() < settings_.neighbours; ++next) {
    Index const node = open[next];
    network_.for_each_operand(node, [&](Literal operand) { add(operand.node()); });
    if (network_[node].is_free()) continue;
    std::span<Index const> const users = network_.users(node);
    for (std::size_t i = 0; i < std::min(users.size(), most_users); ++i) add(users[i]);
  }
  for (Index node : open) is_near_[node] = 0;
  std::erase(near_, Index{1}); // the constant 1
}

// Computes target - other, or target + other.
Residue Proposals::rest(Index other, bool negative) const {
  return negative ? algebra::add(first(target_), first(other)) : subtract(first(target_), first(other));
}

void Proposals::invert_rests() {
  inverse_rests_.clear();
  for (Index other : near_)
    for (bool negative : {false, true}) inverse_rests_.push_back(rest(other, negative));
  invert(inverse_rests_);
}

// Tries target = other + x, or x - other.
void Proposals::try_sum(std::size_t near) {
  Index const other = near_[near];
  for (bool negative : {false, true}) {
    Residue const rest = this->rest(other, negative);
    if (Index const found = network_.find(rest); found != no_index && found != target_ && found != 0) {
      Literal const a = Literal::of(other, negative), b = Literal::of(found, first(found) != rest);
      if (matches(network_.value(a) + network_.value(b), a)) consider({{{{Kind::sum, a, b}}}, 1});
    }
    if (cone_ >= 3 && !network_[other].is_free())
      try_sum_with_multiple(other, negative, inverse_rests_[2 * near + (negative ? 1 : 0)]);
  }
}

// Tries target = other + k x, or k x - other.
void Proposals::try_sum_with_multiple(Index other, bool negative, Residue inverse_rest) {
  Literal const a = Literal::of(other, negative);
  Residue const rest_2 = subtract(network_[target_].value.field[1],
                                  negative ? negate(network_[other].value.field[1]) : network_[other].value.field[1]);
  if (inverse_rest == 0 || rest_2 == 0) return;
  Index const found = by_ratio_.find(multiply(rest_2, inverse_rest));
  if (found == KeyTable::none || found == target_ || found == other || !network_.is_alive(found)) return;
  Proposal proposal{
      {{{Kind::product, Literal::of(found), Proposal::constant_result()}, {Kind::sum, a, Proposal::result(0)}}}, 2};
  if (!multiple_of(network_[target_].value + -network_.value(a), found, proposal.constant)) return;
  consider(proposal);
}

// Tries target = k x.
void Proposals::try_multiple() {
  Index const found = by_ratio_.find(ratio_[target_]);
  if (found == KeyTable::none || found == target_ || !network_.is_alive(found)) return;
  Proposal proposal{{{{Kind::product, Literal::of(found), Proposal::constant_result()}}}, 1};
  if (multiple_of(network_[target_].value, found, proposal.constant)) consider(proposal);
}

// Whether value = k * node for a number k.
bool Proposals::multiple_of(Value const &value, Index node, Value &k) const {
  Value const &base = network_[node].value;
  Residue const factor = multiply(value.field[0], inverse_[node]);
  for (std::size_t i = 0; i < field_points; ++i) {
    k.field[i] = factor;
    if (multiply(factor, base.field[i]) != value.field[i]) return false;
  }
  for (std::size_t i = 0; i < number_points; ++i) k.number[i] = value.number[i] / base.number[i];
  constexpr long double tolerance = 0x1p-40L;
  bool const same = std::fabs(k.number[0] - k.number[1]) <= tolerance * std::fabs(k.number[0]);
  k.number[1] = k.number[0];
  return same && factor != 0 && std::fabs(k.number[0]) < 0x1p60L && std::fabs(k.number[0]) > 0x1p-60L;
}

// Tries target = other * x.
void Proposals::try_product(Index other) {
  Residue const rest = multiply(first(target_), inverse_[other]);
  Index const found = network_.find(rest);
  if (found == no_index || found == target_ || found <= 1) return;
  Literal const a = Literal::of(other), b = Literal::of(found, first(found) != rest);
  if (matches(network_.value(a) * network_.value(b), {})) consider({{{{Kind::product, a, b}}}, 1});
}

// Tabulates sums, differences and products of neighbours by value.
void Proposals::make_pairs() {
  std::size_t const count = std::min(near_.size(), settings_.pairs_among);
  pairs_.clear();
  pair_by_value_ = KeyTable(2 * count * count);
  auto add_pair = [&](Kind kind, Literal a, Literal b, Residue made) {
    std::uint32_t &known = pair_by_value_[magnitude(made)];
    if (known != KeyTable::none) return;
    known = static_cast<std::uint32_t>(pairs_.size());
    pairs_.push_back({kind, a, b, made});
  };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i; j < count; ++j) {
      Literal const a = Literal::of(near_[i]), b = Literal::of(near_[j]);
      add_pair(Kind::product, a, b, multiply(first(a.node()), first(b.node())));
      if (i == j) continue;
      add_pair(Kind::sum, a, b, algebra::add(first(a.node()), first(b.node())));
      add_pair(Kind::sum, a, -b, subtract(first(a.node()), first(b.node())));
    }
  search_.work += pairs_.size() / 2;
}

Value Proposals::value(Pair const &pair) const {
  return pair.kind == Kind::sum ? network_.value(pair.a) + network_.value(pair.b)
                                : network_.value(pair.a) * network_.value(pair.b);
}

// Tries target = pair + other, pair - other, or pair * other.
void Proposals::try_with_pair(Index other) {
  Residue const target = first(target_);
  for (int way = 0; way < 3; ++way) {
    Residue const rest = way == 0   ? subtract(target, first(other))
                         : way == 1 ? algebra::add(target, first(other))
                                    : multiply(target, inverse_[other]);
    std::uint32_t const found = pair_by_value_.find(magnitude(rest));
    if (found == KeyTable::none) continue;
    Pair const &pair = pairs_[found];
    bool const negative = pair.value != rest;
    Literal const a = Literal::of(other, way == 1);
    Value const inner = negative ? -value(pair) : value(pair);
    if (!matches(way == 2 ? network_.value(a) * inner : network_.value(a) + inner, a)) continue;
    consider(
        {{{{pair.kind, pair.a, pair.b}, {way == 2 ? Kind::product : Kind::sum, a, Proposal::result(0, negative)}}}, 2});
  }
}

// Tries target = product + pair, or pair - product.
void Proposals::try_two_products() {
  for (Pair const &x : pairs_)
    for (bool minus : {false, true}) {
      if (x.kind != Kind::product) continue;
      Residue const rest = minus ? algebra::add(first(target_), x.value) : subtract(first(target_), x.value);
      std::uint32_t const found = pair_by_value_.find(magnitude(rest));
      if (found == KeyTable::none || &pairs_[found] == &x) continue;
      Pair const &y = pairs_[found];
      bool const negative = y.value != rest;
      Value const left = minus ? -value(x) : value(x), right = negative ? -value(y) : value(y);
      if (!matches(left + right, {})) continue;
      consider({{{{x.kind, x.a, x.b},
                  {y.kind, y.a, y.b},
                  {Kind::sum, Proposal::result(0, minus), Proposal::result(1, negative)}}},
                3});
    }
}

// Whether `value` equals the target's at all points.
bool Proposals::matches(Value const &value, Literal part) const {
  Value const &target = network_[target_].value;
  return equal_in_field(value, target) && confirmed(value, target, scale_of(network_[part.node()].value));
}

void Proposals::consider(Proposal proposal) {
  std::array<Literal, 6> operands{};
  std::size_t count = 0;
  for (int step = 0; step < proposal.operations; ++step)
    for (Literal operand : {proposal.steps[step].a, proposal.steps[step].b})
      if (!Proposal::is_result(operand)) operands[count++] = operand;
  std::span<Literal const> const used(operands.data(), count);
  for (Literal operand : used)
    if (!network_.is_alive(operand.node()) || network_.needs_it(operand.node()) ||
        !network_.hazards().is_subset(network_[operand.node()].hazards, network_[target_].hazards))
      return;
  ++search_.work;
  int const gain = network_.freed(target_, used) + network_.cost(target_) - proposal.operations;
  if (gain < 0 || gain < best_.gain || (gain == best_.gain && search_.random() % 2 == 0)) return;
  proposal.gain = gain;
  best_ = proposal;
}

} // namespace symreal::algebra
