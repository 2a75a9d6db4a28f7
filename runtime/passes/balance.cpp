#include "passes/balance.h"

#include "passes/pass.h"

#include <limits>
#include <queue>

namespace symreal {

namespace {

constexpr double long_before = -std::numeric_limits<double>::infinity();

// A term, when it is there, and its place among the terms.
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

// Sums and products of several terms as balanced trees: the critical path is shorter, the work the same. What depends
// on no input is there at the beginning.
Graph pass_balance(Graph graph, PassSettings const &settings) {
  Balance balance(settings.costs, [](Node const &) { return 0; });
  return regrouped(graph, [&](Group const &group, NodeTable &table) { return balance(group, table); });
}

} // namespace symreal
