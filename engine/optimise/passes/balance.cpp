#include "engine/optimise/passes/balance.h"

#include "engine/optimise/passes/pass.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace symreal {

namespace {

constexpr double long_before = -std::numeric_limits<double>::infinity();

// A term with its ready time and its place among the terms.
struct Arrival {
  double time;
  std::size_t place;
  SignedNode term;

  bool operator>(Arrival const &other) const { return time != other.time ? time > other.time : place > other.place; }
};

} // namespace

SignedNode Balance::operator()(Group const &group, NodeTable &table) {
  std::vector<Arrival> arrivals;
  for (SignedNode const &term : group.terms) {
    double const time = time_of(term.node, table);
    if (time == long_before && !arrivals.empty() && arrivals.front().time == long_before)
      arrivals.front().term = combined(group.op, arrivals.front().term, term, table);
    else
      arrivals.insert(time == long_before ? arrivals.begin() : arrivals.end(), {time, arrivals.size(), term});
  }
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> open(std::greater<>(), std::move(arrivals));
  std::size_t place = group.terms.size();
  while (true) {
    Arrival const a = open.top();
    open.pop();
    if (open.empty()) return a.term;
    Arrival const b = open.top();
    open.pop();
    bool const in_order = a.place < b.place;
    SignedNode const made = combined(group.op, in_order ? a.term : b.term, in_order ? b.term : a.term, table);
    open.push({b.time + costs_.latency_of(group.op), place++, made});
  }
}

double Balance::time(Node const &node) const {
  if (is_leaf(node.op) || node.attribute != Attribute::variable) return begin_(node);
  double time = long_before;
  for (NodeId operand : node.operand)
    if (operand != no_node) time = std::max(time, times_[operand]);
  return time + costs_.latency_of(node.op);
}

namespace {

Balance from_inputs_on(CostModel const &costs) {
  return Balance(costs, [](Node const &) { return 0; });
}

// Length of the longest path through each node.
std::vector<double> paths_through(Graph const &graph, CostModel const &costs) {
  std::vector<char> const live = live_nodes(graph);
  Balance times = from_inputs_on(costs);
  std::vector<double> through(graph.nodes.size(), 0), tails = through;
  for (auto id = static_cast<NodeId>(graph.nodes.size()); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!live[id] || is_leaf(node.op) || node.attribute != Attribute::variable) continue;
    through[id] = times.time_of(id, graph.nodes) + tails[id];
    for (unsigned i = 0; i < arity(node.op); ++i)
      tails[node.operand[i]] = std::max(tails[node.operand[i]], tails[id] + costs.latency_of(node.op));
  }
  return through;
}

Graph balanced(Graph const &graph, CostModel const &costs, std::function<bool(NodeId)> const &is_chosen) {
  Balance balance = from_inputs_on(costs);
  return regrouped(graph, [&](Group const &group, NodeTable &table) {
    return is_chosen(group.end) ? std::optional(balance(group, table)) : std::nullopt;
  });
}

double longest(std::vector<double> const &paths) { return paths.empty() ? 0 : *std::ranges::max_element(paths); }

} // namespace

double span(Graph const &graph, CostModel const &costs) { return longest(paths_through(graph, costs)); }

// Balances sums and products where this shortens the critical path; the work stays the same.
Graph pass_balance(Graph graph, PassSettings const &settings) {
  CostModel const &costs = settings.costs;
  double const least = span(balanced(graph, costs, [](NodeId) { return true; }), costs);
  for (double last = std::numeric_limits<double>::infinity(); true;) {
    std::vector<double> const through = paths_through(graph, costs);
    double const now = longest(through);
    if (now <= least || now >= last) return graph;
    last = now;
    graph = balanced(graph, costs, [&](NodeId id) { return through[id] > least; });
  }
}

} // namespace symreal
