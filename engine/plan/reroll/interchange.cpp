#include "engine/plan/reroll/interchange.h"

#include "engine/plan/reroll/chains.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace symreal::reroll {

namespace {

// Rows: periodic stages of chains, grouped so that each row has one period of them.
struct Rows {
  std::size_t first, period; // the first stage, and the number of stages per row
  Nest nest;                 // turn by turn the chains that have all stages of the row

  std::size_t end() const { return first + period * nest.turns; }
};

constexpr std::size_t most_stages = 8; // per row
constexpr std::uint32_t least_rows = 4, least_chains_of_row = 2;

class RowSearch {
public:
  RowSearch(Sequence const &sequence, Chains const &chains, std::vector<std::uint32_t> const &depths)
      : sequence_(sequence),
        chains_(chains),
        depths_(depths),
        longest_(chains.length(0) > chains.length(chains.size() - 1) ? 0 : chains.size() - 1) {
    for (std::uint32_t const depth : depths) {
      counts_.push_back(0);
      for (std::size_t chain = 0; chain < chains.size(); ++chain) counts_.back() += chains.length(chain) >= depth;
    }
  }

  // Finds the rows that hold the most operations.
  std::optional<Rows> run() const {
    std::optional<Rows> best;
    for (std::size_t period = 1; period <= most_stages; ++period) {
      std::size_t const last = depths_.size() - 1;
      for (std::size_t begin = 0, end; begin + period < last; begin = end) {
        end = begin;
        while (end + period < last && are_alike(end, end + period)) ++end;
        if (std::optional<Rows> const rows = even(begin, end + period, period); rows && holds(rows) > holds(best))
          best = rows;
        if (end == begin) ++end;
      }
    }
    return best;
  }

private:
  std::size_t holds(std::optional<Rows> const &rows) const {
    if (!rows) return 0;
    std::size_t operations = 0;
    for (std::size_t stage = rows->first; stage < rows->end(); ++stage)
      operations += std::size_t{counts_[stage]} * (depths_[stage] - depths_[stage + 1]);
    return operations;
  }

  // Rows at the end of the stages begin..end-1 that an equal number of chains joins from row to row.
  std::optional<Rows> even(std::size_t begin, std::size_t end, std::size_t period) const {
    std::size_t const last = end - period;
    if (last < begin + period) return {};
    std::int64_t const growth = joining(last, period);
    std::size_t first = last;
    while (first >= begin + period && joining(first, period) == growth &&
           counts_[first - period] >= least_chains_of_row)
      first -= period;
    auto const rows = static_cast<std::uint32_t>((last - first) / period + 1);
    if (rows < least_rows || growth < 0) return {};
    return Rows{first, period, {rows, counts_[first], static_cast<std::int32_t>(growth)}};
  }
  std::int64_t joining(std::size_t stage, std::size_t period) const {
    return static_cast<std::int64_t>(counts_[stage]) - counts_[stage - period];
  }

  // Whether two stages of the longest chain match, with operands from the chain equally far back.
  bool are_alike(std::size_t stage, std::size_t other) const {
    std::uint32_t const size = depths_[stage] - depths_[stage + 1], end = chains_.ends[longest_];
    if (depths_[other] - depths_[other + 1] != size) return false;
    std::uint32_t const begin = end - depths_[stage], other_begin = end - depths_[other];
    for (std::uint32_t k = 0; k < size; ++k)
      if (!are_alike_at(begin + k, other_begin + k)) return false;
    return true;
  }
  bool are_alike_at(std::uint32_t a, std::uint32_t b) const {
    auto const back = [&](NodeId node, std::uint32_t at) {
      std::uint32_t const made = sequence_.position[node];
      return made == no_position || made < chains_.begin(longest_) ? 0 : at - made;
    };
    auto const fit = [&](NodeId x, NodeId y) {
      return sequence_.array(x) == sequence_.array(y) && back(x, a) == back(y, b);
    };
    return match(sequence_.operations[a], sequence_.operations[b], fit) != Match::none;
  }

  Sequence const &sequence_;
  Chains const &chains_;
  std::vector<std::uint32_t> const &depths_;
  std::size_t longest_;
  std::vector<std::uint32_t> counts_; // per depth: number of chains at least that long
};

// `depths`: begins of stages, in operations before the ends of chains, descending to 0. Returns nullopt if rows are too
// few, or if chains do not join them evenly. Takes the time of comparing the longest chain with itself a few times.
std::optional<Rows> find_rows(Sequence const &sequence, Chains const &chains,
                              std::vector<std::uint32_t> const &depths) {
  return RowSearch(sequence, chains, depths).run();
}

constexpr std::uint32_t least_chains_of_stage = 8; // one stage is seldom worth a loop, all together are

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
      if (repeat.count >= least_chains_of_stage) order_.stages.push_back(repeat);
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
