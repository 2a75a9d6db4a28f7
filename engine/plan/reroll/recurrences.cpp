#include "engine/plan/reroll/recurrences.h"

#include "engine/optimise/algebra/recovery.h"
#include "engine/optimise/passes/balance.h"

#include <algorithm>
#include <limits>

namespace symreal::reroll {

namespace {

using Places = std::vector<std::uint32_t>; // of leaves

// Operations that a processor issues within the latency of one: commonly four cycles for a sum or product, with two
// issued per cycle.
constexpr double begun_meanwhile = 8;

std::vector<char> depend_on(LoopStep const &step, Places const &leaves) {
  Graph const &body = step.body;
  std::vector<char> depends(body.nodes.size(), 0);
  for (NodeId id = 0; id < body.nodes.size(); ++id) {
    Node const &node = body.nodes[id];
    if (node.op == Op::input) depends[id] = std::ranges::find(leaves, node.slot()) != leaves.end();
    for (unsigned i = 0; i < arity(node.op) && !is_leaf(node.op); ++i)
      depends[id] = depends[id] || depends[node.operand[i]];
  }
  return depends;
}

// Paths from the leaves of one recurrence to their next values.
class Paths {
public:
  Paths(LoopStep const &step, Places const &leaves) : step_(step), leaves_(leaves) {
    std::vector<char> const after = depend_on(step, leaves);
    is_on_path_.assign(after.size(), 0);
    for (std::uint32_t const k : leaves) is_on_path_[step.leaves[k].next] = 1;
    for (auto id = static_cast<NodeId>(after.size()); id-- > 0;) {
      if (!after[id]) is_on_path_[id] = 0;
      Node const &node = step.body.nodes[id];
      for (unsigned i = 0; i < arity(node.op) && !is_leaf(node.op) && is_on_path_[id]; ++i)
        is_on_path_[node.operand[i]] = 1;
    }
  }

  // The least time from one iteration to the next, by bisection.
  double period() const {
    double low = 0, high = longest_path(0); // as if all carried values were ready at time 0
    while (high - low > 0.1) (longest_path((low + high) / 2) <= (low + high) / 2 ? high : low) = (low + high) / 2;
    return high;
  }

  LoopStep shortened() const {
    Balance balance = this->balance(period());
    LoopStep other = step_;
    other.body = regrouped(step_.body, [&](Group const &group, NodeTable &table) {
      return is_on_path_[group.end] ? std::optional(balance(group, table)) : std::nullopt;
    });
    std::size_t result = 0;
    for (Store &store : other.stores) store.value = other.body.results[result++];
    for (Leaf &leaf : other.leaves)
      if (leaf.is_carried) leaf.next = other.body.results[result++];
    return other;
  }

private:
  // Ready times, counted from the start of an iteration.
  Balance balance(double period) const {
    return Balance(usual_costs(), [this, period](Node const &node) {
      if (!is_within(node)) return -std::numeric_limits<double>::infinity();
      return -period * static_cast<double>(handed_on(node.slot()));
    });
  }
  // Number of iterations that a leaf's value is carried over; the number of leaves for a value that never changes.
  std::size_t handed_on(std::uint32_t leaf) const {
    for (std::size_t iterations = 0; iterations < leaves_.size(); ++iterations) {
      Node const &next = step_.body.nodes[step_.leaves[leaf].next];
      if (!is_within(next)) return iterations;
      leaf = next.slot();
    }
    return leaves_.size();
  }
  bool is_within(Node const &node) const {
    return node.op == Op::input && std::ranges::find(leaves_, node.slot()) != leaves_.end();
  }

  // Latency from the carried-in values to the carried-out ones.
  double longest_path(double period) const {
    Balance times = balance(period);
    double longest = 0;
    for (std::uint32_t const k : leaves_)
      longest = std::max(longest, times.time_of(step_.leaves[k].next, step_.body.nodes));
    return longest;
  }

  LoopStep const &step_;
  Places const &leaves_;
  std::vector<char> is_on_path_; // per node
};

} // namespace

std::vector<Recurrence> recurrences(LoopStep const &step) {
  Places carried;
  for (std::uint32_t k = 0; k < step.leaves.size(); ++k)
    if (step.leaves[k].is_carried) carried.push_back(k);
  std::size_t const count = carried.size();
  std::vector<std::vector<char>> reaches; // within an iteration, then over any number of them
  for (std::uint32_t const from : carried) {
    std::vector<char> const depends = depend_on(step, {from});
    reaches.emplace_back();
    for (std::uint32_t const to : carried) reaches.back().push_back(depends[step.leaves[to].next]);
  }
  for (std::size_t through = 0; through < count; ++through)
    for (std::size_t from = 0; from < count; ++from)
      for (std::size_t to = 0; to < count && reaches[from][through]; ++to)
        reaches[from][to] = reaches[from][to] || reaches[through][to];
  std::vector<Recurrence> found;
  std::vector<char> is_done(count, 0);
  for (std::size_t a = 0; a < count; ++a) {
    if (is_done[a] || !reaches[a][a]) continue;
    Places leaves;
    for (std::size_t b = a; b < count; ++b)
      if (reaches[a][b] && reaches[b][a]) is_done[b] = 1, leaves.push_back(carried[b]);
    double const period = Paths(step, leaves).period();
    found.push_back({std::move(leaves), period});
  }
  return found;
}

LoopStep with_short_recurrences(LoopStep step) {
  if (step.count == 1) return step;
  for (auto const &[leaves, period] : recurrences(step)) {
    if (period * begun_meanwhile < algebra::cost_of(step.body, usual_costs())) continue;
    LoopStep other = Paths(step, leaves).shortened();
    if (Paths(other, leaves).period() < period &&
        algebra::cost_of(other.body, usual_costs()) <= algebra::cost_of(step.body, usual_costs()))
      step = std::move(other);
  }
  return step;
}

} // namespace symreal::reroll
