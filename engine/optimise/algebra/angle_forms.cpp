#include "engine/optimise/algebra/angle_forms.h"

#include <algorithm>
#include <cmath>

namespace symreal::algebra {

namespace {

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

} // namespace

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
    Function const &function = network.function_of(network[node]);
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

bool are_related(std::vector<Angle> const &angles, Network const &network) {
  std::map<Index, int> uses;
  for (Angle const &angle : angles)
    for (auto const &[atom, quarters] : angle.form)
      if (!network[atom].is_free() && ++uses[atom] == 2) return true;
  return false;
}

} // namespace symreal::algebra
