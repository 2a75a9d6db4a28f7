#include "engine/optimise/algebra/angle_sums.h"

namespace symreal::algebra {

namespace {

// Cost of all live nodes, functions included.
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

// Two angles with a node that equals the sine or cosine of their sum or difference, and the point of that angle.
struct CallCandidate {
  Index a, b;
  bool is_minus;
  Value angle, sine_value, cosine_value;
  std::optional<Literal> sine = {}, cosine = {};
};

class CallCandidates {
public:
  explicit CallCandidates(Network const &network) : network_(network), live_(live_nodes(network)) {
    constexpr std::size_t most_angles = 64;
    for (Angle const &angle : angles_of(network)) {
      Value const value = network[angle.node].value;
      Angles const &angles = network.context()->angles;
      points_.push_back({angle.node, value, angles.sine(value), angles.cosine(value)});
    }
    if (points_.size() > most_angles) return;
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t j = i; j < points_.size(); ++j)
        for (bool is_minus : {false, true})
          if (i != j || !is_minus) look_at(points_[i], points_[j], is_minus);
  }

  std::vector<CallCandidate> found;

private:
  struct Point {
    Index node;
    Value angle, sine, cosine;
  };

  void look_at(Point const &a, Point const &b, bool is_minus) {
    Value const angle = is_minus ? -b.angle : b.angle, sine = is_minus ? -b.sine : b.sine;
    CallCandidate candidate = {a.node,
                               b.node,
                               is_minus,
                               a.angle + angle,
                               a.sine * b.cosine + a.cosine * sine,
                               a.cosine * b.cosine + -(a.sine * sine)};
    candidate.sine = find(candidate.sine_value, a.node, b.node);
    candidate.cosine = find(candidate.cosine_value, a.node, b.node);
    if (candidate.sine || candidate.cosine) found.push_back(candidate);
  }

  // The node with this value if it is computed after both angles and has their hazards, else nullopt.
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
  std::vector<Point> points_;
};

Network with_call(Network const &network, CallCandidate const &candidate) {
  auto replacement = [&](Index node, Network &result, LiteralMap const &now) -> std::optional<Literal> {
    auto is = [&](std::optional<Literal> const &found) { return found && found->node() == node; };
    if (!is(candidate.sine) && !is(candidate.cosine)) return std::nullopt;
    bool const is_sine = is(candidate.sine);
    std::optional<Literal> const &found = is_sine ? candidate.sine : candidate.cosine;
    Literal const angle = result.sum(now[candidate.a], now[candidate.b].negated_if(candidate.is_minus));
    Literal const call = result.function({is_sine ? Op::sin : Op::cos, 1, {angle}});
    return call.negated_if(found && found->is_negative());
  };
  return rebuilt(rewritten(network, replacement));
}

} // namespace

Network with_calls_of_angle_sums(Network network, CostModel const &costs) {
  constexpr std::size_t largest = 20'000;
  if (network.size() > largest) return network;
  double cost = total_cost(network, costs);
  for (int tries = 64; tries > 0;) {
    bool is_better = false;
    for (CallCandidate const &candidate : CallCandidates(network).found) {
      if (tries-- == 0 || is_better) break;
      network.context()->angles.set(candidate.angle, candidate.sine_value, candidate.cosine_value);
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
