#include "algebra/resubstitution.h"

#include "algebra/mutable_network.h"

#include <algorithm>

namespace symreal::algebra {

namespace {

// How a node can be made: up to three operations, the last one of which is the node. An operand may be the result of an
// earlier step, or the constant.
struct Proposal {
  struct Step {
    Kind kind;
    Literal a, b;
  };
  static constexpr std::uint32_t first_result = ~std::uint32_t{0} - 15;
  static Literal result(std::uint32_t step, bool negative = false) {
    return {first_result + 2 * step + static_cast<std::uint32_t>(negative)};
  }
  static Literal constant_result() { return result(7); }
  static bool is_result(Literal literal) { return literal.bits >= first_result; }

  std::array<Step, 3> steps{};
  int operations = 0;
  int gain = -1;
  Value constant{};
};

class Resubstitution {
public:
  Resubstitution(Network const &network, ResubstitutionSettings const &settings, Search &search)
      : network_(network),
        settings_(settings),
        search_(search),
        is_near_(network.size(), 0) {
    for (Index node = 0; node < network_.size(); ++node) add_inverse(node);
  }

  Network run() {
    for (Index node : order()) {
      if (!network_.is_alive(node)) continue;
      target_ = node;
      cone_ = network_.cone_cost(node);
      best_ = {};
      look_around();
      network_.look_for_users(target_);
      std::erase_if(near_, [&](Index near) { return network_.needs_it(near); });
      search_.work += 2 * near_.size();
      for (Index other : near_) {
        try_sum(other);
        try_product(other);
      }
      try_multiple();
      if (cone_ >= 2) try_pairs();
      if (best_.gain > 0 || (best_.gain == 0 && chance() < settings_.sideways)) apply();
    }
    return network_.finished();
  }

private:
  double chance() { return static_cast<double>(search_.random() >> 11) * 0x1p-53; }
  Residue first(Index node) const { return network_[node].value.field[0]; }

  void add_inverse(Index node) {
    inverse_.push_back(inverse(first(node)));
    Residue const second = network_[node].value.field[1];
    ratio_.push_back(multiply(second, inverse_.back()));
    if (network_[node].is_free() || !network_.is_alive(node)) return;
    if (std::uint32_t &known = by_ratio_[ratio_.back()]; known == KeyTable::none) known = node;
  }

  std::vector<Index> order() {
    std::vector<Index> nodes;
    for (Index node = 0; node < network_.size(); ++node)
      if (network_.is_alive(node) && network_[node].cost() != 0) nodes.push_back(node);
    for (std::size_t i = nodes.size(); i > 1; --i) std::swap(nodes[i - 1], nodes[search_.random() % i]);
    if (settings_.largest_first) {
      std::vector<int> size(network_.size());
      for (Index node : nodes) size[node] = network_.cone_cost(node);
      std::ranges::stable_sort(nodes, std::greater(), [&](Index node) { return size[node]; });
    }
    return nodes;
  }

  // What the target is made of, and what else is made of that, nearest first.
  void look_around() {
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
    std::erase(near_, Index{1}); // one
  }

  // target = other + x, or x - other.
  void try_sum(Index other) {
    Value const &target = network_[target_].value;
    for (bool negative : {false, true}) {
      Residue const rest = negative ? add(target.field[0], first(other)) : subtract(target.field[0], first(other));
      if (Index const found = network_.find(rest); found != no_index && found != target_ && found != 0) {
        Literal const a = Literal::of(other, negative), b = Literal::of(found, first(found) != rest);
        if (matches(network_.value(a) + network_.value(b), a)) consider({{{{Kind::sum, a, b}}}, 1});
      }
      if (cone_ >= 3 && !network_[other].is_free()) try_sum_with_multiple(other, negative, rest);
    }
  }

  // target = other + k x, or k x - other.
  void try_sum_with_multiple(Index other, bool negative, Residue rest) {
    Literal const a = Literal::of(other, negative);
    Residue const rest_2 = subtract(network_[target_].value.field[1],
                                    negative ? negate(network_[other].value.field[1]) : network_[other].value.field[1]);
    if (rest == 0 || rest_2 == 0) return;
    Index const found = by_ratio_.find(multiply(rest_2, inverse(rest)));
    if (found == KeyTable::none || found == target_ || found == other || !network_.is_alive(found)) return;
    Proposal proposal{
        {{{Kind::product, Literal::of(found), Proposal::constant_result()}, {Kind::sum, a, Proposal::result(0)}}}, 2};
    if (!multiple_of(network_[target_].value + -network_.value(a), found, proposal.constant)) return;
    consider(proposal);
  }

  // target = k x.
  void try_multiple() {
    Index const found = by_ratio_.find(ratio_[target_]);
    if (found == KeyTable::none || found == target_ || !network_.is_alive(found)) return;
    Proposal proposal{{{{Kind::product, Literal::of(found), Proposal::constant_result()}}}, 1};
    if (multiple_of(network_[target_].value, found, proposal.constant)) consider(proposal);
  }

  // Whether value = k * node for a number k.
  bool multiple_of(Value const &value, Index node, Value &k) const {
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

  // target = other * x.
  void try_product(Index other) {
    Residue const rest = multiply(first(target_), inverse_[other]);
    Index const found = network_.find(rest);
    if (found == no_index || found == target_ || found <= 1) return;
    Literal const a = Literal::of(other), b = Literal::of(found, first(found) != rest);
    if (matches(network_.value(a) * network_.value(b), {})) consider({{{{Kind::product, a, b}}}, 1});
  }

  // The target as a sum or product of a neighbour and of what two others make, or as the sum of two products.
  void try_pairs() {
    std::vector<Index> among = near_;
    if (among.size() > settings_.pairs_among) among.resize(settings_.pairs_among);
    struct Pair {
      Kind kind;
      Literal a, b;
      Residue value;
    };
    std::vector<Pair> pairs;
    KeyTable by_value(among.size() * among.size() * 2);
    auto add_pair = [&](Kind kind, Literal a, Literal b, Residue value) {
      std::uint32_t &known = by_value[magnitude(value)];
      if (known != KeyTable::none) return;
      known = static_cast<std::uint32_t>(pairs.size());
      pairs.push_back({kind, a, b, value});
    };
    for (std::size_t i = 0; i < among.size(); ++i)
      for (std::size_t j = i; j < among.size(); ++j) {
        Literal const a = Literal::of(among[i]), b = Literal::of(among[j]);
        add_pair(Kind::product, a, b, multiply(first(a.node()), first(b.node())));
        if (i == j) continue;
        add_pair(Kind::sum, a, b, add(first(a.node()), first(b.node())));
        add_pair(Kind::sum, a, -b, subtract(first(a.node()), first(b.node())));
      }
    search_.work += pairs.size() / 2;
    auto value = [&](Pair const &pair) {
      return pair.kind == Kind::sum ? network_.value(pair.a) + network_.value(pair.b)
                                    : network_.value(pair.a) * network_.value(pair.b);
    };
    Residue const target = first(target_);
    for (Index other : among)
      for (int way = 0; way < 3; ++way) {
        Residue const rest = way == 0   ? subtract(target, first(other))
                             : way == 1 ? add(target, first(other))
                                        : multiply(target, inverse_[other]);
        std::uint32_t const found = by_value.find(magnitude(rest));
        if (found == KeyTable::none) continue;
        Pair const &pair = pairs[found];
        bool const negative = pair.value != rest;
        Literal const a = Literal::of(other, way == 1);
        Value const inner = negative ? -value(pair) : value(pair);
        if (!matches(way == 2 ? network_.value(a) * inner : network_.value(a) + inner, a)) continue;
        consider(
            {{{{pair.kind, pair.a, pair.b}, {way == 2 ? Kind::product : Kind::sum, a, Proposal::result(0, negative)}}},
             2});
      }
    if (cone_ < 3) return;
    for (Pair const &x : pairs)
      for (bool minus : {false, true}) {
        if (x.kind != Kind::product) continue;
        Residue const rest = minus ? add(target, x.value) : subtract(target, x.value);
        std::uint32_t const found = by_value.find(magnitude(rest));
        if (found == KeyTable::none || &pairs[found] == &x) continue;
        Pair const &y = pairs[found];
        bool const negative = y.value != rest;
        Value const left = minus ? -value(x) : value(x), right = negative ? -value(y) : value(y);
        if (!matches(left + right, {})) continue;
        consider({{{{x.kind, x.a, x.b},
                    {y.kind, y.a, y.b},
                    {Kind::sum, Proposal::result(0, minus), Proposal::result(1, negative)}}},
                  3});
      }
  }

  // Whether this is the target's value, at all points.
  bool matches(Value const &value, Literal part) const {
    Value const &target = network_[target_].value;
    return equal_in_field(value, target) && confirmed(value, target, scale_of(network_[part.node()].value));
  }

  void consider(Proposal proposal) {
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
    int const gain = network_.freed(target_, used) + network_[target_].cost() - proposal.operations;
    if (gain < 0 || gain < best_.gain || (gain == best_.gain && search_.random() % 2 == 0)) return;
    proposal.gain = gain;
    best_ = proposal;
  }

  void apply() {
    std::array<Literal, 3> results{};
    Literal constant;
    if (std::ranges::any_of(best_.steps, [](auto &step) { return step.b == Proposal::constant_result(); })) {
      constant = network_.constant(best_.constant);
      add_inverse(constant.node());
    }
    auto now = [&](Literal literal) {
      if (!Proposal::is_result(literal)) return literal;
      std::uint32_t const step = (literal.bits - Proposal::first_result) / 2;
      return (step == 7 ? constant : results[step]).negated_if((literal.bits - Proposal::first_result) % 2 != 0);
    };
    int const last = best_.operations - 1;
    for (int i = 0; i < last; ++i) {
      results[i] = network_.make(best_.steps[i].kind, now(best_.steps[i].a), now(best_.steps[i].b));
      add_inverse(results[i].node());
    }
    network_.replace(target_, best_.steps[last].kind, now(best_.steps[last].a), now(best_.steps[last].b));
  }

  MutableNetwork network_;
  ResubstitutionSettings const &settings_;
  Search &search_;
  std::vector<Residue> inverse_, ratio_; // of the values at the first point; of those at the first two
  KeyTable by_ratio_;
  std::vector<Index> near_;
  std::vector<char> is_near_;
  Index target_ = 0;
  int cone_ = 0; // of what is there for the target alone
  Proposal best_;
};

} // namespace

Network resubstituted(Network const &network, ResubstitutionSettings const &settings, Search &search) {
  return Resubstitution(network, settings, search).run();
}

} // namespace symreal::algebra
