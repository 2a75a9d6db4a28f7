#include "reroll/interchange.h"

#include "reroll/chains.h"

#include <algorithm>

namespace symreal::reroll {

namespace {

constexpr std::uint32_t least_chains = 8; // in a stage that becomes a loop: a stage alone is seldom worth it, all are

// Operations of the old sequence in a new order, with the loops among them.
struct Order {
  std::vector<std::uint32_t> operations = {};
  std::vector<Repeat> stages = {};
};

// The stages of all chains: a stage is what lies between the beginnings of two.
void add_stages(Chains const &chains, Order &order) {
  std::vector<std::uint32_t> depths = chains.common;
  depths.push_back(0);
  std::ranges::sort(depths, std::greater());
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  for (std::size_t stage = 0; stage + 1 < depths.size(); ++stage) {
    std::uint32_t const from = depths[stage], to = depths[stage + 1];
    Repeat repeat{static_cast<std::uint32_t>(order.operations.size()), from - to, 0};
    auto const finish = [&] {
      if (repeat.count >= least_chains) order.stages.push_back(repeat);
      repeat = {static_cast<std::uint32_t>(order.operations.size()), from - to, 0};
    };
    for (std::size_t j = 0; j < chains.size(); ++j) {
      if (j > 0 && chains.common[j - 1] < from) finish();
      if (chains.length(j) < from) continue;
      for (std::uint32_t depth = from; depth > to; --depth) order.operations.push_back(chains.ends[j] - depth);
      ++repeat.count;
    }
    finish();
  }
}

Order new_order(Sequence const &sequence, std::vector<Chains> const &all) {
  std::vector<char> moves(sequence.size(), 0);
  for (Chains const &chains : all)
    for (std::size_t j = 0; j < chains.size(); ++j)
      std::fill(moves.begin() + chains.begin(j), moves.begin() + chains.ends[j], 1);
  Order order;
  auto next = all.begin();
  for (std::uint32_t at = 0; at <= sequence.size(); ++at) {
    for (; next != all.end() && next->ends.back() == at; ++next) add_stages(*next, order);
    if (at < sequence.size() && !moves[at]) order.operations.push_back(at);
  }
  return order;
}

Sequence in_order(Sequence sequence, std::vector<std::uint32_t> const &order) {
  std::vector<Operation> operations;
  operations.reserve(order.size());
  for (std::uint32_t const at : order) {
    sequence.position[sequence.operations[at].node] = static_cast<std::uint32_t>(operations.size());
    operations.push_back(sequence.operations[at]);
  }
  sequence.operations = std::move(operations);
  return sequence;
}

// Two groups of chains may each be moved, but not both.
bool is_in_order(Sequence const &sequence) {
  for (std::uint32_t at = 0; at < sequence.size(); ++at)
    for (unsigned i = 0; i < sequence.operations[at].count; ++i) {
      std::uint32_t const made = sequence.position[sequence.operations[at].operands[i].node];
      if (made != no_position && made >= at) return false;
    }
  return true;
}

} // namespace

Interchanged interchanged(Sequence sequence) {
  std::vector<Chains> const chains = find_chains(sequence);
  if (chains.empty()) return {std::move(sequence)};
  Order const order = new_order(sequence, chains);
  Sequence changed = in_order(sequence, order.operations);
  if (!is_in_order(changed)) return {std::move(sequence)};
  return {std::move(changed), order.stages};
}

} // namespace symreal::reroll
