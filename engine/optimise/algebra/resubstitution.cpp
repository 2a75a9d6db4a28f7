#include "engine/optimise/algebra/mutable_network.h"
#include "engine/optimise/algebra/search.h"

namespace symreal::algebra {

namespace {

constexpr std::size_t most_neighbours = 60;   // nodes tried per target
constexpr std::size_t paired_neighbours = 24; // neighbours that are combined in pairs
constexpr double sideways = 0.3;              // probability of accepting a change without gain

// Operation on nodes, results of earlier steps, or the constant.
struct ProposalStep {
  Kind kind;
  Literal a, b;
};

// Computation of a node in up to three operations, the last of which is the node.
struct Proposal {
  static constexpr std::uint32_t first_result = ~std::uint32_t{0} - 15;
  static Literal result(std::uint32_t step, bool negative = false) {
    return {first_result + 2 * step + static_cast<std::uint32_t>(negative)};
  }
  static Literal constant_result() { return result(7); }
  static bool is_result(Literal literal) { return literal.bits >= first_result; }

  std::array<ProposalStep, 3> steps{};
  int operations = 0;
  int gain = -1;
  Value constant{};
};

// Finds the best proposal for each node.
class Proposals {
public:
  Proposals(MutableNetwork &network, SearchState &search)
      : network_(network),
        search_(search),
        is_near_(network.size(), 0) {
    for (Index node = 0; node < network_.size(); ++node) add(node);
  }

  Proposal best_for(Index target) {
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
      for (std::size_t i = 0; i < std::min(near_.size(), paired_neighbours); ++i) try_with_pair(near_[i]);
    }
    if (cone_ >= 3) try_two_products();
    return best_;
  }

  // Registers each node added to the network, in order.
  void add(Index node) {
    inverse_.push_back(inverse(first(node)));
    Residue const second = network_[node].value.field[1];
    ratio_.push_back(multiply(second, inverse_.back()));
    if (network_[node].is_free() || !network_.is_alive(node)) return;
    if (std::uint32_t &known = by_ratio_[ratio_.back()]; known == KeyTable::none) known = node;
  }

private:
  struct Pair {
    Kind kind;
    Literal a, b;
    Residue value;
  };

  Residue first(Index node) const { return network_[node].value.field[0]; }

  // Collects the neighbourhood of the target: its operands and their users, breadth first.
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
    for (std::size_t next = 0; next < open.size() && near_.size() < most_neighbours; ++next) {
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
  Residue rest(Index other, bool negative) const {
    return negative ? algebra::add(first(target_), first(other)) : subtract(first(target_), first(other));
  }

  void invert_rests() {
    inverse_rests_.clear();
    for (Index other : near_)
      for (bool negative : {false, true}) inverse_rests_.push_back(rest(other, negative));
    invert(inverse_rests_);
  }

  // Tries target = other + x, or x - other.
  void try_sum(std::size_t near) {
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
  void try_sum_with_multiple(Index other, bool negative, Residue inverse_rest) {
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

  // Tries target = other * x.
  void try_product(Index other) {
    Residue const rest = multiply(first(target_), inverse_[other]);
    Index const found = network_.find(rest);
    if (found == no_index || found == target_ || found <= 1) return;
    Literal const a = Literal::of(other), b = Literal::of(found, first(found) != rest);
    if (matches(network_.value(a) * network_.value(b), {})) consider({{{{Kind::product, a, b}}}, 1});
  }

  // Tabulates sums, differences and products of neighbours by value.
  void make_pairs() {
    std::size_t const count = std::min(near_.size(), paired_neighbours);
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

  Value value(Pair const &pair) const {
    return pair.kind == Kind::sum ? network_.value(pair.a) + network_.value(pair.b)
                                  : network_.value(pair.a) * network_.value(pair.b);
  }

  // Tries target = pair + other, pair - other, or pair * other.
  void try_with_pair(Index other) {
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
          {{{{pair.kind, pair.a, pair.b}, {way == 2 ? Kind::product : Kind::sum, a, Proposal::result(0, negative)}}},
           2});
    }
  }

  // Tries target = product + pair, or pair - product.
  void try_two_products() {
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
    int const gain = network_.freed(target_, used) + network_.cost(target_) - proposal.operations;
    if (gain < 0 || gain < best_.gain || (gain == best_.gain && search_.random() % 2 == 0)) return;
    proposal.gain = gain;
    best_ = proposal;
  }

  MutableNetwork &network_;
  SearchState &search_;
  std::vector<Residue> inverse_, ratio_; // inverse of the value at point 0; ratio of those at points 1 and 0
  KeyTable by_ratio_;
  std::vector<Index> near_;
  std::vector<Residue> inverse_rests_; // two per neighbour
  std::vector<char> is_near_;
  std::vector<Pair> pairs_;
  KeyTable pair_by_value_;
  Index target_ = 0;
  int cone_ = 0; // cost of the target's fanout-free cone
  Proposal best_;
};

class Resubstitution {
public:
  Resubstitution(Network const &network, bool largest_first, SearchState &search)
      : network_(network),
        largest_first_(largest_first),
        search_(search),
        proposals_(network_, search) {}

  Network run() {
    for (Index node : order()) {
      if (search_.is_over()) break;
      if (!network_.is_alive(node)) continue;
      Proposal const best = proposals_.best_for(node);
      if (best.gain > 0 || (best.gain == 0 && search_.chance() < sideways)) apply(node, best);
    }
    return network_.finished();
  }

private:
  std::vector<Index> order() {
    std::vector<Index> nodes;
    for (Index node = 0; node < network_.size(); ++node)
      if (network_.is_alive(node) && network_.cost(node) != 0) nodes.push_back(node);
    search_.shuffle(nodes);
    if (largest_first_) {
      std::vector<int> size(network_.size());
      for (Index node : nodes) size[node] = network_.cone_cost(node);
      std::ranges::stable_sort(nodes, std::greater(), [&](Index node) { return size[node]; });
    }
    return nodes;
  }

  void apply(Index target, Proposal const &proposal) {
    std::array<Literal, 3> results{};
    Literal constant;
    if (std::ranges::any_of(proposal.steps, [](auto &step) { return step.b == Proposal::constant_result(); })) {
      constant = network_.constant(proposal.constant);
      proposals_.add(constant.node());
    }
    auto now = [&](Literal literal) {
      if (!Proposal::is_result(literal)) return literal;
      std::uint32_t const step = (literal.bits - Proposal::first_result) / 2;
      return (step == 7 ? constant : results[step]).negated_if((literal.bits - Proposal::first_result) % 2 != 0);
    };
    int const last = proposal.operations - 1;
    for (int i = 0; i < last; ++i) {
      results[i] = network_.make(proposal.steps[i].kind, now(proposal.steps[i].a), now(proposal.steps[i].b));
      proposals_.add(results[i].node());
    }
    network_.replace(target, proposal.steps[last].kind, now(proposal.steps[last].a), now(proposal.steps[last].b));
  }

  MutableNetwork network_;
  bool largest_first_;
  SearchState &search_;
  Proposals proposals_;
};

} // namespace

Network resubstituted(Network const &network, bool largest_first, SearchState &search) {
  return Resubstitution(network, largest_first, search).run();
}

} // namespace symreal::algebra
