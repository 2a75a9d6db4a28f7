#include "algebra/angle_forms.h"
#include "algebra/angle_sums.h"

#include <utility>

namespace symreal::algebra {

namespace {

// Of what the roots need, functions included.
double total_cost(Network const &network, CostModel const &costs) {
  std::vector<char> const live = live_nodes(network);
  double sum = 0;
  for (Index index = 0; index < network.size(); ++index) {
    NetworkNode const &node = network[index];
    if (!live[index] || node.is_free()) continue;
    switch (node.kind) {
    case Kind::constant:
    case Kind::leaf: break;
    case Kind::sum: sum += costs[Op::add]; break;
    case Kind::product: sum += costs[Op::mul]; break;
    case Kind::quotient: sum += costs[Op::div]; break;
    case Kind::function: sum += costs[network.function_of(node).op]; break;
    }
  }
  return sum;
}

// Two angles whose sum or difference the network has the sine or cosine of.
struct Candidate {
  Index a, b;
  bool is_minus;
  std::optional<Literal> sine, cosine;
};

class Candidates {
public:
  explicit Candidates(Network const &network) : network_(network), live_(live_nodes(network)) {
    constexpr std::size_t most_angles = 64;
    std::vector<Angle> const angles = angles_of(network);
    if (angles.size() > most_angles) return;
    for (std::size_t i = 0; i < angles.size(); ++i)
      for (std::size_t j = i; j < angles.size(); ++j)
        for (bool is_minus : {false, true})
          if (i != j || !is_minus) look_at(angles[i].node, angles[j].node, is_minus);
  }

  std::vector<Candidate> found;

private:
  void look_at(Index a, Index b, bool is_minus) {
    Angles const &angles = network_.context()->angles;
    Value const x = network_[a].value, y = is_minus ? -network_[b].value : network_[b].value;
    Value const sine = angles.sine(x) * angles.cosine(y) + angles.cosine(x) * angles.sine(y);
    Value const cosine = angles.cosine(x) * angles.cosine(y) + -(angles.sine(x) * angles.sine(y));
    Candidate const candidate = {a, b, is_minus, find(sine, a, b), find(cosine, a, b)};
    if (candidate.sine || candidate.cosine) found.push_back(candidate);
  }

  // Computed after the angles, and resting on them.
  std::optional<Literal> find(Value const &value, Index a, Index b) const {
    std::optional<Literal> const literal = network_.find(value);
    if (!literal) return std::nullopt;
    Index const node = literal->node();
    auto rests_on = [&](Index angle) {
      return angle < node && network_.hazards().is_subset(network_[angle].hazards, network_[node].hazards);
    };
    bool const is_one = live_[node] && network_[node].is_arithmetic() && !network_[node].is_free() && rests_on(a);
    return is_one && rests_on(b) ? literal : std::nullopt;
  }

  Network const &network_;
  std::vector<char> live_;
};

Network with_call(Network const &network, Candidate const &candidate) {
  std::vector<char> const live = live_nodes(network);
  std::vector<Literal> now(network.size());
  auto literal = [&](Literal old) { return now[old.node()].negated_if(old.is_negative()); };
  Network result(network.context());
  for (Index node = 0; node < network.size(); ++node) {
    if (!live[node]) continue;
    auto is = [&](std::optional<Literal> const &found) { return found && found->node() == node; };
    if (is(candidate.sine) || is(candidate.cosine)) {
      Op const op = is(candidate.sine) ? Op::sin : Op::cos;
      Literal const angle = result.sum(now[candidate.a], now[candidate.b].negated_if(candidate.is_minus));
      Literal const call = result.function({op, 1, {angle}});
      now[node] = call.negated_if((op == Op::sin ? candidate.sine : candidate.cosine)->is_negative());
    } else {
      now[node] = result.copy(network, network[node], literal);
    }
  }
  for (Literal root : network.roots) result.roots.push_back(literal(root));
  return rebuilt(result);
}

} // namespace

Network with_calls_of_angle_sums(Network network, CostModel const &costs) {
  constexpr std::size_t largest = 20'000;
  if (network.size() > largest) return network;
  double cost = total_cost(network, costs);
  for (int tries = 64; tries > 0;) {
    bool is_better = false;
    for (Candidate const &candidate : Candidates(network).found) {
      if (tries-- == 0 || is_better) break;
      Angles &angles = network.context()->angles;
      Value const x = network[candidate.a].value;
      Value const y = candidate.is_minus ? -network[candidate.b].value : network[candidate.b].value;
      angles.set(x + y, angles.sine(x) * angles.cosine(y) + angles.cosine(x) * angles.sine(y),
                 angles.cosine(x) * angles.cosine(y) + -(angles.sine(x) * angles.sine(y)));
      Network next = with_call(network, candidate);
      if (double const next_cost = total_cost(next, costs); next_cost < cost) {
        network = std::move(next);
        cost = next_cost;
        is_better = true;
      }
    }
    if (!is_better) break;
  }
  return network;
}

} // namespace symreal::algebra
