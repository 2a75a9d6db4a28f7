#include "engine/plan/reroll/rows.h"

namespace symreal::reroll {

namespace {

constexpr std::size_t most_stages = 8; // per row
constexpr std::uint32_t least_rows = 4, least_chains = 2;

class Finder {
public:
  Finder(Sequence const &sequence, Chains const &chains, std::vector<std::uint32_t> const &depths)
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
    while (first >= begin + period && joining(first, period) == growth && counts_[first - period] >= least_chains)
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
      return sequence_.source(x) == sequence_.source(y) && back(x, a) == back(y, b);
    };
    return match(sequence_.operations[a], sequence_.operations[b], fit) != Match::none;
  }

  Sequence const &sequence_;
  Chains const &chains_;
  std::vector<std::uint32_t> const &depths_;
  std::size_t longest_;
  std::vector<std::uint32_t> counts_; // per depth: number of chains at least that long
};

} // namespace

std::optional<Rows> find_rows(Sequence const &sequence, Chains const &chains,
                              std::vector<std::uint32_t> const &depths) {
  return Finder(sequence, chains, depths).run();
}

} // namespace symreal::reroll
