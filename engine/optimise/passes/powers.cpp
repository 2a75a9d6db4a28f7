#include "engine/graph/node_table.h"
#include "engine/optimise/passes/addition_sequence.h"
#include "engine/optimise/passes/pass.h"

#include <cmath>
#include <map>

namespace symreal {

namespace {

// Exponents are stored in halves: 5 is x^2.5. Each multiplication rounds, so x^n is off by at most n / 2 units in the
// last place, which bounds n.
constexpr int most_halves = 2 * 64;

// All powers of one base. Positive powers are products; negative ones are reciprocals of products, or products of one
// reciprocal.
class PowersOfBase {
public:
  PowersOfBase(std::map<int, std::vector<NodeId>> const &exponents, CostModel const &costs) : costs_(costs) {
    for (auto const &[halves, nodes] : exponents) (halves > 0 ? positive_ : negative_).push_back(std::abs(halves));
    std::vector<int> all = positive_;
    for (int halves : negative_)
      if (std::ranges::find(all, halves) == all.end()) all.push_back(halves);
    double const each = cost_of_products(all) + costs_[Op::div] * static_cast<double>(negative_.size());
    double const one = cost_of_products(positive_) + costs_[Op::div] + cost_of_products(negative_);
    has_reciprocal_ = !negative_.empty() && one < each;
    cost_ = has_reciprocal_ ? one : each;
    if (!has_reciprocal_) positive_ = std::move(all);
  }

  double cost() const { return cost_; }

  // Nodes of the powers, keyed by exponent.
  std::map<int, NodeId> make(NodeId base, NodeTable &table) const {
    std::map<int, NodeId> powers = products(base, positive_, table);
    if (has_reciprocal_) {
      NodeId const inverse = reciprocal(base, table);
      for (auto const &[halves, node] : products(inverse, negative_, table)) powers.emplace(-halves, node);
    } else {
      for (int halves : negative_) powers.emplace(-halves, reciprocal(powers.at(halves), table));
    }
    return powers;
  }

private:
  static bool has_root(std::vector<int> const &exponents) {
    return std::ranges::any_of(exponents, [](int halves) { return halves % 2 != 0; });
  }
  static std::vector<Addition> additions(std::vector<int> const &exponents) {
    return addition_sequence(has_root(exponents) ? std::vector{1, 2} : std::vector{2}, exponents);
  }
  double cost_of_products(std::vector<int> const &exponents) const {
    if (exponents.empty()) return 0;
    return static_cast<double>(additions(exponents).size()) * costs_[Op::mul] +
           (has_root(exponents) ? costs_[Op::sqrt] : 0);
  }

  static NodeId reciprocal(NodeId node, NodeTable &table) {
    return table.intern(table.operation(Op::div, table.constant(1), node));
  }
  static std::map<int, NodeId> products(NodeId base, std::vector<int> const &exponents, NodeTable &table) {
    std::map<int, NodeId> powers;
    if (exponents.empty()) return powers;
    powers[2] = base;
    if (has_root(exponents)) powers[1] = table.intern(table.operation(Op::sqrt, base));
    for (Addition const &addition : additions(exponents))
      powers[addition.sum] = table.intern(table.operation(Op::mul, powers.at(addition.a), powers.at(addition.b)));
    return powers;
  }

  CostModel const &costs_;
  std::vector<int> positive_, negative_;
  bool has_reciprocal_ = false;
  double cost_ = 0;
};

// Exponent in halves if multiplications can make the power, else 0.
int halves_of(Graph const &graph, NodeId id) {
  Node const &node = graph.nodes[id];
  if (node.op != Op::pow || node.attribute != Attribute::variable) return 0;
  if (!graph.node_exact.empty() && graph.node_exact[id]) return 0;
  Node const &exponent = graph.nodes[node.operand[1]];
  if (!exponent.is_constant()) return 0;
  double const halves = 2 * exponent.value();
  return std::trunc(halves) == halves && std::fabs(halves) <= most_halves ? static_cast<int>(halves) : 0;
}

} // namespace

// Shares products among the powers of one base: x^2, x^3 and x^6 take three multiplications.
Graph pass_powers(Graph graph, PassSettings const &settings) {
  std::vector<char> const live = live_nodes(graph);
  std::map<NodeId, std::map<int, std::vector<NodeId>>> bases; // per base, nodes by exponent
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (int const halves = live[id] ? halves_of(graph, id) : 0) bases[graph.nodes[id].operand[0]][halves].push_back(id);
  if (bases.empty()) return graph;

  NodeTable table;
  std::vector<NodeId> now(graph.nodes.size(), no_node);
  std::vector<char> is_made(graph.nodes.size(), 0);
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    if (is_made[id]) continue;
    Node node = graph.nodes[id];
    if (!is_leaf(node.op))
      for (NodeId &operand : node.operand)
        if (operand != no_node) operand = now[operand];
    NodeId const base = graph.nodes[id].operand[0];
    auto const found = live[id] && halves_of(graph, id) != 0 ? bases.find(base) : bases.end();
    if (found != bases.end()) {
      PowersOfBase const powers(found->second, settings.costs);
      if (powers.cost() < settings.costs[Op::pow] * static_cast<double>(found->second.size())) {
        std::map<int, NodeId> const made = powers.make(now[base], table);
        for (auto const &[halves, nodes] : found->second)
          for (NodeId power : nodes) now[power] = made.at(halves), is_made[power] = 1;
      }
      bases.erase(found);
    }
    if (!is_made[id]) now[id] = table.intern(node);
  }
  Graph result = without_nodes(graph);
  result.nodes = table.release();
  carry_over(graph, now, result);
  return result;
}

} // namespace symreal
