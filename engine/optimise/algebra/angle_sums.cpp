#include "engine/optimise/algebra/angle_sums.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace symreal::algebra {

namespace {

// Limits: large multiples lose accuracy, and long sums are rarely related.
constexpr int most_quarters = 4 * 8;
constexpr std::size_t longest_angle = 8;
constexpr int most_weight = 8; // of a plan

AngleForm listed(std::map<Index, int> const &quarters) {
  AngleForm form;
  for (auto const &[atom, count] : quarters)
    if (count != 0) form.emplace_back(atom, count);
  return form;
}

bool is_good(std::map<Index, int> const &quarters) {
  return quarters.size() <= longest_angle &&
         std::ranges::all_of(quarters, [](auto const &part) { return std::abs(part.second) <= most_quarters; });
}

// Quarters of a node in `number` times `quarters` of it; 0 if they are not a whole number.
int times(NetworkNode const &number, int quarters) {
  long double const value = number.value.number[0] * quarters;
  bool const is_whole = std::fabs(value) <= most_quarters && std::nearbyint(value) == value;
  auto const result = is_whole ? static_cast<int>(value) : 0;
  Value const expected = value_of(static_cast<double>(result));
  return equal_in_field(expected, number.value * value_of(static_cast<double>(quarters))) ? result : 0;
}

AngleForm operator+(AngleForm const &a, AngleForm const &b) {
  std::map<Index, int> sum(a.begin(), a.end());
  for (auto const &[atom, quarters] : b) sum[atom] += quarters;
  return listed(sum);
}

AngleForm operator-(AngleForm const &a) {
  AngleForm result = a;
  for (auto &[atom, quarters] : result) quarters = -quarters;
  return result;
}

// Builds the form as a node of `network`; `now` maps its atoms.
Literal made_of(AngleForm const &form, Network &network, LiteralMap const &now) {
  Literal sum = network.zero();
  for (auto const &[atom, quarters] : form)
    sum = network.sum(sum, network.product(network.constant(quarters / 4.0), now(Literal::of(atom))));
  return sum;
}

// Whether two angles, or multiples of one, share an input; only then can one serve another.
bool are_related(std::vector<Angle> const &angles, Network const &network) {
  std::map<Index, int> uses;
  for (Angle const &angle : angles)
    for (auto const &[atom, quarters] : angle.form)
      if (!network[atom].is_free() && ++uses[atom] == 2) return true;
  return false;
}

enum TrigFunction : std::size_t { sines, cosines };

// The angle +-a +-b.
struct AngleSum {
  std::size_t a = 0, b = 0;
  bool is_minus_a = false, is_minus_b = false;

  // Double angle: sin 2a = 2 s c, cos 2a = 1 - 2 s^2 or 2 c^2 - 1.
  bool is_double() const { return a == b && is_minus_a == is_minus_b; }
};

// Plan of an angle's sine and cosine: by calls, or derived from two other angles.
struct AnglePlan {
  Angle angle;
  int weight = 1; // number of angles with calls, by multiplicity
  bool is_derived = false, is_free = false;
  AngleSum sum = {};
  bool is_there[2] = {};
};

class Planning {
public:
  Planning(Network const &network, CostModel const &costs) : network_(network), costs_(costs) {
    std::vector<Angle> angles = angles_of(network);
    std::ranges::stable_sort(angles, {}, [&](Angle const &angle) { return size_of(angle.form); });
    for (Angle &angle : angles) add(std::move(angle));
  }

  std::vector<AnglePlan> plans;

private:
  // Size of the part that depends on inputs; simple angles come first, since others derive from them.
  int size_of(AngleForm const &form) const {
    int sum = 0;
    for (auto const &[atom, quarters] : form)
      if (!network_[atom].is_free()) sum += std::abs(quarters);
    return sum;
  }

  void add(Angle angle) {
    AnglePlan plan{.angle = std::move(angle)};
    plan.is_there[sines] = plan.angle.sine != no_index;
    plan.is_there[cosines] = plan.angle.cosine != no_index;
    double best = 0; // largest saving
    std::size_t const known = plans.size();
    AnglePlan chosen = plan;
    for (std::size_t a = 0; a < known; ++a) {
      if (plans[a].is_free || !may_use(plan, plans[a])) continue;
      for (bool is_minus : {false, true}) {
        AngleForm const rest = plan.angle.form + (is_minus ? plans[a].angle.form : -plans[a].angle.form);
        std::optional<std::pair<std::size_t, bool>> const b = find(plan, rest);
        if (!b) continue;
        AnglePlan derived = plan;
        derived.is_derived = true;
        derived.sum = {a, b->first, is_minus, b->second};
        derived.weight = plans[a].weight + plans[b->first].weight;
        if (derived.weight > most_weight) continue;
        double const saved = saving(derived);
        if (saved > best) best = saved, chosen = derived;
      }
    }
    if (chosen.is_derived) {
      for (TrigFunction part : {sines, cosines})
        if (chosen.is_there[part]) require(chosen.sum, part);
    }
    by_form_.emplace(chosen.angle.form, plans.size());
    plans.push_back(std::move(chosen));
  }

  // Whether `part` is computed before the functions of `plan` and has a subset of its hazards.
  bool may_use(AnglePlan const &plan, AnglePlan const &part) const {
    Index const first = std::min(plan.angle.sine, plan.angle.cosine);
    return part.angle.node < first &&
           network_.hazards().is_subset(network_[part.angle.node].hazards, network_[plan.angle.node].hazards);
  }

  // The angle of this form or its negative. Adds a plan for a form that depends on parameters alone.
  std::optional<std::pair<std::size_t, bool>> find(AnglePlan const &plan, AngleForm const &form) {
    for (bool is_negative : {false, true}) {
      auto const found = by_form_.find(is_negative ? -form : form);
      if (found != by_form_.end() && (plans[found->second].is_free || may_use(plan, plans[found->second])))
        return std::pair(found->second, is_negative);
    }
    Index const first = std::min(plan.angle.sine, plan.angle.cosine);
    for (auto const &[atom, quarters] : form)
      if (!network_[atom].is_free() || atom >= first ||
          !network_.hazards().is_subset(network_[atom].hazards, network_[plan.angle.node].hazards))
        return std::nullopt;
    if (form.empty()) return std::nullopt;
    by_form_.emplace(form, plans.size());
    plans.push_back({.angle = {.form = form, .node = no_index}, .is_free = true, .is_there = {true, true}});
    return std::pair(plans.size() - 1, false);
  }

  // Cost of making this part of an angle available.
  double cost_of(std::size_t angle, TrigFunction part) const {
    AnglePlan const &plan = plans[angle];
    if (plan.is_there[part]) return 0;
    if (!plan.is_derived) return costs_[part == sines ? Op::sin : Op::cos];
    return cost_of(plan.sum, part);
  }
  double cost_of(AngleSum const &sum, TrigFunction part) const {
    double const multiplication = costs_[Op::mul], addition = costs_[Op::add];
    if (sum.is_double()) {
      if (part == sines) return 2 * multiplication + cost_of(sum.a, sines) + cost_of(sum.a, cosines);
      return 2 * multiplication + addition + std::min(cost_of(sum.a, sines), cost_of(sum.a, cosines));
    }
    double cost = 2 * multiplication + addition;
    for (std::size_t of : {sum.a, sum.b}) cost += cost_of(of, sines) + cost_of(of, cosines);
    return cost;
  }

  // A lower bound: parts that sine and cosine share are counted twice.
  double saving(AnglePlan const &plan) const {
    double saved = 0;
    if (plan.is_there[sines]) saved += costs_[Op::sin] - cost_of(plan.sum, sines);
    if (plan.is_there[cosines]) saved += costs_[Op::cos] - cost_of(plan.sum, cosines);
    return saved;
  }

  void require(std::size_t angle, TrigFunction part) {
    AnglePlan &plan = plans[angle];
    if (std::exchange(plan.is_there[part], true) || !plan.is_derived) return;
    require(AngleSum(plan.sum), part);
  }
  void require(AngleSum const &sum, TrigFunction part) {
    if (sum.is_double() && part == cosines) {
      require(sum.a, plans[sum.a].is_there[sines] || cost_of(sum.a, sines) < cost_of(sum.a, cosines) ? sines : cosines);
      return;
    }
    for (std::size_t of : {sum.a, sum.b}) {
      require(of, sines);
      require(of, cosines);
    }
  }

  Network const &network_;
  CostModel const &costs_;
  std::map<AngleForm, std::size_t> by_form_;
};

class Substitution {
public:
  Substitution(Network const &network, Planning const &planning)
      : network_(network),
        plans_(planning.plans),
        made_(plans_.size()),
        now_(network.size()),
        result_(network.context()) {}

  Network run() {
    std::vector<std::size_t> plan_of(network_.size(), plans_.size());
    for (std::size_t i = 0; i < plans_.size(); ++i)
      if (plans_[i].is_derived)
        for (Index function : {plans_[i].angle.sine, plans_[i].angle.cosine})
          if (function != no_index) plan_of[function] = i;
    std::vector<char> const live = live_nodes(network_);
    for (Index node = 0; node < network_.size(); ++node) {
      if (!live[node]) continue;
      if (std::size_t const plan = plan_of[node]; plan != plans_.size())
        now_[node] = part(plan, network_.function_of(network_[node]).op == Op::sin ? sines : cosines);
      else
        now_[node] = result_.copy(network_, network_[node], now_);
    }
    for (Literal root : network_.roots) result_.roots.push_back(now_(root));
    return std::move(result_);
  }

private:
  // The weight bounds the recursion depth.
  Literal part(std::size_t number, TrigFunction which) {
    std::optional<Literal> &known = made_[number][which];
    if (!known) known = make(plans_[number], which);
    return *known;
  }

  Literal make(AnglePlan const &plan, TrigFunction which) {
    if (!plan.is_derived) {
      Literal const angle = plan.is_free ? made_of(plan.angle.form, result_, now_) : now_[plan.angle.node];
      return result_.function({which == sines ? Op::sin : Op::cos, 1, {angle}});
    }
    AngleSum const &sum = plan.sum;
    Literal const two = result_.constant(2.0), one = result_.one();
    if (sum.is_double() && which == cosines) {
      bool const by_sine = plans_[sum.a].is_there[sines];
      Literal const x = part(sum.a, by_sine ? sines : cosines);
      Literal const squares = result_.product(two, result_.product(x, x));
      return by_sine ? result_.sum(one, -squares) : result_.sum(squares, -one);
    }
    Literal const sine_a = part(sum.a, sines).negated_if(sum.is_minus_a), cosine_a = part(sum.a, cosines);
    if (sum.is_double()) return result_.product(two, result_.product(sine_a, cosine_a));
    Literal const sine_b = part(sum.b, sines).negated_if(sum.is_minus_b), cosine_b = part(sum.b, cosines);
    if (which == sines) return result_.sum(result_.product(sine_a, cosine_b), result_.product(cosine_a, sine_b));
    return result_.sum(result_.product(cosine_a, cosine_b), -result_.product(sine_a, sine_b));
  }

  Network const &network_;
  std::vector<AnglePlan> const &plans_;
  std::vector<std::array<std::optional<Literal>, 2>> made_;
  LiteralMap now_;
  Network result_;
};

void relate(AngleForm const &form, Network const &network) {
  Value sum = value_of(0);
  std::vector<AnglePart> parts;
  for (auto const &[atom, quarters] : form) {
    parts.push_back({network[atom].value, quarters});
    sum = sum + network[atom].value * value_of(quarters / 4.0);
  }
  network.context()->angles.add(sum, parts);
}

// Sets field points of the angles that share atoms with others.
void relate(std::vector<Angle> const &angles, Network const &network) {
  std::map<Index, int> uses;
  for (Angle const &angle : angles)
    for (auto const &[atom, quarters] : angle.form) ++uses[atom];
  for (Angle const &angle : angles) {
    bool const is_related = std::ranges::any_of(angle.form, [&](auto const &part) { return uses[part.first] > 1; });
    if (is_related) relate(angle.form, network);
  }
}

} // namespace

AngleForm form_of(Network const &network, Index angle) {
  constexpr int most_steps = 100;
  std::map<Index, int> sum;
  std::vector<std::pair<Literal, int>> open = {{Literal::of(angle), 4}};
  for (int steps = 0; !open.empty(); ++steps) {
    auto const [literal, signless] = open.back();
    open.pop_back();
    int const quarters = literal.is_negative() ? -signless : signless;
    NetworkNode const &node = network[literal];
    bool const first_is_number = node.kind == Kind::product && network[node.a].attribute == Attribute::constant;
    bool const second_is_number = node.kind == Kind::product && network[node.b].attribute == Attribute::constant;
    int const multiple = first_is_number    ? times(network[node.a], quarters)
                         : second_is_number ? times(network[node.b], quarters)
                                            : 0;
    if (node.kind == Kind::sum) {
      open.emplace_back(node.a, quarters);
      open.emplace_back(node.b, quarters);
    } else if (multiple != 0) {
      open.emplace_back(first_is_number ? node.b : node.a, multiple);
    } else {
      sum[literal.node()] += quarters;
    }
    if (steps == most_steps) return {{angle, 4}};
  }
  return is_good(sum) ? listed(sum) : AngleForm{{angle, 4}};
}

std::vector<Angle> angles_of(Network const &network) {
  std::vector<char> const live = live_nodes(network);
  std::map<Index, Angle> angles;
  for (Index node = 0; node < network.size(); ++node) {
    if (!live[node] || network[node].kind != Kind::function || network[node].is_free()) continue;
    OpaqueFunction const &function = network.function_of(network[node]);
    if ((function.op != Op::sin && function.op != Op::cos) || function.origin != 0) continue;
    Index const angle = function.operands[0].node();
    (function.op == Op::sin ? angles[angle].sine : angles[angle].cosine) = node;
  }
  std::vector<Angle> result;
  for (auto &[node, angle] : angles) {
    angle.node = node;
    angle.form = form_of(network, node);
    result.push_back(std::move(angle));
  }
  return result;
}

Network with_angle_sums(Network const &network, CostModel const &costs) {
  std::vector<Angle> const angles = angles_of(network);
  constexpr std::size_t most_angles = 200; // all pairs are tried
  if (angles.size() > most_angles || !are_related(angles, network)) return network;
  relate(angles, network);
  Planning const planning(network, costs);
  for (AnglePlan const &plan : planning.plans)
    if (plan.is_free) relate(plan.angle.form, network);
  return Substitution(network, planning).run();
}

} // namespace symreal::algebra
