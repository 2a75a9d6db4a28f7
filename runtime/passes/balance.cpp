#include "passes/groups.h"
#include "passes/pass.h"

#include <queue>

namespace symreal {

namespace {

// A term, when it is there, and its place among the terms.
struct Arrival {
  double time;
  std::size_t place;
  SignedNode term;

  bool operator>(Arrival const &other) const { return time != other.time ? time > other.time : place > other.place; }
};

class Balance {
public:
  explicit Balance(CostModel const &costs) : costs_(costs) {}

  // Of the terms the two that are there first are put together first, as in Huffman's code: no tree is ready earlier.
  // Nothing where the group is ready as early as it stands.
  std::optional<SignedNode> operator()(Group const &group, NodeTable &table) {
    std::vector<Arrival> arrivals;
    for (SignedNode const &term : group.terms) arrivals.push_back({time_of(term.node, table), arrivals.size(), term});
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

private:
  // When the node is there if all begin as early as they can.
  double time_of(NodeId id, NodeTable const &table) {
    for (auto next = static_cast<NodeId>(times_.size()); next <= id; ++next) {
      Node const &node = table[next];
      double time = 0;
      if (!is_leaf(node.op) && node.attribute == Attribute::variable) {
        for (NodeId operand : node.operand)
          if (operand != no_node) time = std::max(time, times_[operand]);
        time += costs_.latency_of(node.op);
      }
      times_.push_back(time);
    }
    return times_[id];
  }

  CostModel const &costs_;
  std::vector<double> times_; // per node of the table
};

} // namespace

// Sums and products of several terms as balanced trees: the critical path is shorter, the work the same.
Graph pass_balance(Graph graph, PassSettings const &settings) {
  Balance balance(settings.costs);
  return regrouped(graph, [&](Group const &group, NodeTable &table) { return balance(group, table); });
}

} // namespace symreal
