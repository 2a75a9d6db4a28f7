#include "engine/plan/reroll/interchange.h"

#include "engine/plan/reroll/rows.h"

#include <algorithm>
#include <numeric>

namespace symreal::reroll {

namespace {

constexpr std::uint32_t least_chains = 8; // per stage: one stage is seldom worth a loop, all together are
struct Order {
  std::vector<std::uint32_t> operations = {};
  std::vector<Repeat> stages = {};
};

// Adds the stages of a group of chains to an order. A stage lies between the beginnings of two chains.
class Stages {
public:
  Stages(Sequence const &sequence, Chains const &chains, Order &order)
      : sequence_(sequence),
        chains_(chains),
        order_(order),
        depths_(chains.common),
        chain_(chains.size()) {
    depths_.push_back(0);
    std::ranges::sort(depths_, std::greater());
    depths_.erase(std::unique(depths_.begin(), depths_.end()), depths_.end());
    std::iota(chain_.begin(), chain_.end(), std::size_t{0});
  }

  void add(bool in_rows) {
    std::size_t const end = depths_.size() - 1;
    std::optional<Rows> const rows = in_rows ? find_rows(sequence_, chains_, depths_) : std::nullopt;
    if (!rows) return add_one_by_one(0, end);
    // The longest chains go first, so that chains that join later come behind the others.
    if (chains_.length(0) < chains_.length(chains_.size() - 1)) std::ranges::reverse(chain_);
    add_one_by_one(0, rows->first);
    for (std::size_t const chain : chain_) add_to_row(chain, *rows);
    add_rows(*rows);
    add_one_by_one(rows->end(), end);
  }

private:
  bool has(std::size_t chain, std::size_t stage) const { return chains_.length(chain) >= depths_[stage]; }

  void add_operations(std::size_t chain, std::size_t from, std::size_t to) {
    for (std::uint32_t depth = depths_[from]; depth > depths_[to]; --depth)
      order_.operations.push_back(chains_.ends[chain] - depth);
  }

  void add_one_by_one(std::size_t from, std::size_t to) {
    for (std::size_t stage = from; stage < to; ++stage) add_stage(stage);
  }

  void add_stage(std::size_t stage) {
    Repeat const none{static_cast<std::uint32_t>(order_.operations.size()), depths_[stage] - depths_[stage + 1], 0};
    Repeat repeat = none;
    auto const finish = [&] {
      if (repeat.count >= least_chains) order_.stages.push_back(repeat);
      repeat = none;
      repeat.begin = static_cast<std::uint32_t>(order_.operations.size());
    };
    for (std::size_t k = 0; k < chain_.size(); ++k) {
      if (k > 0 && chains_.common[std::min(chain_[k - 1], chain_[k])] < depths_[stage]) finish();
      if (!has(chain_[k], stage)) continue;
      add_operations(chain_[k], stage, stage + 1);
      ++repeat.count;
    }
    finish();
  }

  // Adds the stages of a chain before its first row.
  void add_to_row(std::size_t chain, Rows const &rows) {
    std::size_t first = 0, row = rows.first;
    while (!has(chain, first)) ++first;
    while (row < first) row += rows.period;
    if (first > rows.first && row <= rows.end()) add_operations(chain, first, row);
  }

  void add_rows(Rows const &rows) {
    Repeat repeat{static_cast<std::uint32_t>(order_.operations.size()),
                  depths_[rows.first] - depths_[rows.first + rows.period], 0, rows.nest};
    for (std::size_t stage = rows.first; stage < rows.end(); stage += rows.period)
      for (std::size_t const chain : chain_) {
        if (!has(chain, stage)) continue;
        add_operations(chain, stage, stage + rows.period);
        ++repeat.count;
      }
    order_.stages.push_back(repeat);
  }

  Sequence const &sequence_;
  Chains const &chains_;
  Order &order_;
  std::vector<std::uint32_t> depths_; // begins of stages, in operations before the ends of chains
  std::vector<std::size_t> chain_;    // in order
};

Order new_order(Sequence const &sequence, std::vector<Chains> const &all, bool in_rows) {
  std::vector<char> moves(sequence.size(), 0);
  for (Chains const &chains : all)
    for (std::size_t j = 0; j < chains.size(); ++j)
      std::fill(moves.begin() + chains.begin(j), moves.begin() + chains.ends[j], 1);
  Order order;
  auto next = all.begin();
  for (std::uint32_t at = 0; at <= sequence.size(); ++at) {
    for (; next != all.end() && next->ends.back() == at; ++next) Stages(sequence, *next, order).add(in_rows);
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

// Whether definitions precede uses: two groups of chains may each be movable, but not both.
bool is_in_order(Sequence const &sequence) {
  for (std::uint32_t at = 0; at < sequence.size(); ++at)
    for (unsigned i = 0; i < sequence.operations[at].count; ++i) {
      std::uint32_t const made = sequence.position[sequence.operations[at].operands[i].node];
      if (made != no_position && made >= at) return false;
    }
  return true;
}

} // namespace

Interchanged interchanged(Sequence sequence, bool in_rows) {
  std::vector<Chains> const chains = find_chains(sequence);
  if (chains.empty()) return {std::move(sequence)};
  Order const order = new_order(sequence, chains, in_rows);
  Sequence changed = in_order(sequence, order.operations);
  if (!is_in_order(changed)) return {std::move(sequence)};
  return {std::move(changed), order.stages};
}

} // namespace symreal::reroll
