#include "engine/plan/reroll/repeats.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <unordered_map>

namespace symreal::reroll {

namespace {

bool operands_match(Sequence const &sequence, std::uint32_t at, NodeId a, NodeId b, std::uint32_t period) {
  Array const kind = sequence.array(a);
  if (kind != sequence.array(b)) return false;
  if (kind != Array::memory || a == b) return true;
  std::uint32_t const back_a = at - sequence.position[a], back_b = at + period - sequence.position[b];
  return back_a == back_b || (back_a > period && back_b > period);
}

// The first operand of a lookup is the number of its table.
bool names_table(Op op) { return op == Op::lookup || op == Op::lookup2; }

// Match of the operation at `at` and the one a period later.
Match match(Sequence const &sequence, std::uint32_t at, std::uint32_t period) {
  Operation const &a = sequence.operations[at], &b = sequence.operations[at + period];
  if (names_table(a.op) && a.operands[0].node != b.operands[0].node) return Match::none;
  return match(a, b, [&](NodeId x, NodeId y) { return operands_match(sequence, at, x, y, period); });
}

// Thresholds for a loop: operations that it saves, and their percentage of the function, or a saving that suffices at
// any percentage. Small loops inside straight-line code cost more than they save.
constexpr std::uint32_t least_saving = 24, least_part = 50, ample_saving = 300;
bool is_worth_it(Sequence const &sequence, Repeat const &repeat) {
  std::size_t const saving = repeat.count < least_count ? 0 : std::size_t{repeat.count - 1} * repeat.period;
  return saving >= least_saving && (saving * least_part >= sequence.size() || saving >= ample_saving);
}

// Hash of an operation by its kind and the relative positions of its operands, equal in all copies of a window.
std::uint64_t token(Sequence const &sequence, std::uint32_t at) {
  constexpr std::uint32_t far = 16;
  Operation const &operation = sequence.operations[at];
  std::array<std::uint64_t, 3> words = {};
  for (unsigned i = 0; i < operation.count; ++i) {
    NodeId const node = operation.operands[i].node;
    Array const kind = sequence.array(node);
    std::uint32_t const back = kind == Array::memory ? std::min(at - sequence.position[node], far) : 0;
    words[i] = std::uint64_t{back} * 16 + static_cast<std::uint64_t>(kind) + 1;
  }
  if (operation.may_exchange && words[1] < words[0]) std::swap(words[0], words[1]);
  std::uint64_t hash = static_cast<std::uint64_t>(operation.op);
  for (std::uint64_t word : words) hash = hash * 1000 + word;
  return hash;
}

// Candidates for periods: the most frequent distances at which short windows recur.
std::vector<std::uint32_t> likely_periods(Sequence const &sequence) {
  constexpr std::size_t window = 12, most_periods = 48, most_returns = 4;
  std::vector<std::uint64_t> tokens(sequence.size());
  for (std::uint32_t at = 0; at < sequence.size(); ++at) tokens[at] = token(sequence, at);
  std::unordered_map<std::uint64_t, std::array<std::uint32_t, most_returns>> seen; // positions, the newest first
  std::unordered_map<std::uint32_t, std::size_t> votes;
  std::vector<std::uint64_t> const hashes = window_hashes(tokens, window);
  for (std::uint32_t at = 0; at < hashes.size(); ++at) {
    auto const [entry, is_new] = seen.try_emplace(hashes[at]);
    if (is_new) entry->second.fill(no_position);
    for (std::uint32_t const before : entry->second)
      if (before != no_position) ++votes[at - before];
    std::shift_right(entry->second.begin(), entry->second.end(), 1);
    entry->second.front() = at;
  }
  std::vector<std::pair<std::size_t, std::uint32_t>> ranked;
  for (auto const &[period, count] : votes) ranked.emplace_back(count, period);
  std::ranges::sort(ranked, [](auto const &a, auto const &b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  if (ranked.size() > most_periods) ranked.resize(most_periods);
  std::vector<std::uint32_t> periods;
  for (auto const &[count, period] : ranked) periods.push_back(period);
  return periods;
}

struct Stretch {
  std::uint32_t begin, end, period; // operations begin..end-1, of which each matches the one a period later

  std::uint32_t size() const { return end - begin; }
  Repeat repeat() const { return {begin, period, size() / period}; }
  // Priority: longer stretches first, then shorter periods, then earlier begins.
  bool operator<(Stretch const &other) const {
    if (size() != other.size()) return size() < other.size();
    return period != other.period ? period > other.period : begin > other.begin;
  }
};

bool matches(Sequence const &sequence, Repeat const &repeat) {
  for (std::uint32_t at = repeat.begin; at + repeat.period < repeat.end(); ++at)
    if (match(sequence, at, repeat.period) == Match::none) return false;
  return true;
}

void add_stretches(Sequence const &sequence, std::uint32_t period, std::priority_queue<Stretch> &stretches) {
  std::uint32_t begin = 0;
  auto const end_at = [&](std::uint32_t end) {
    Stretch const stretch{begin, end + period, period};
    if (end > begin && is_worth_it(sequence, stretch.repeat())) stretches.push(stretch);
    begin = end + 1;
  };
  std::uint32_t at = 0;
  for (; at + period < sequence.size(); ++at)
    if (match(sequence, at, period) == Match::none) end_at(at);
  end_at(at);
}

// Live values per cut: per operation of the period from `from` on, the number of values computed before it and used
// from it on, within a period after their computation.
std::vector<std::uint32_t> crossings(Sequence const &sequence, std::uint32_t from, std::uint32_t period) {
  // Distance to the last use, per value of the period before `from` and the one after.
  std::vector<std::uint32_t> last_use(std::size_t{2} * period, 0);
  std::uint32_t const first = from - period;
  for (std::uint32_t at = first; at < from + 2 * period && at < sequence.size(); ++at) {
    Operation const &operation = sequence.operations[at];
    for (unsigned i = 0; i < operation.count; ++i) {
      std::uint32_t const made = sequence.position[operation.operands[i].node];
      if (made == no_position || made < first || made >= from + period || at - made > period) continue;
      last_use[made - first] = std::max(last_use[made - first], at - made);
    }
  }
  std::vector<std::int64_t> change(period + 1, 0);
  for (std::uint32_t k = 0; k < 2 * period; ++k) { // live before operations made + 1 up to its last use
    std::int64_t const made = std::int64_t{k} - period, begin = std::max<std::int64_t>(made + 1, 0),
                       end = std::min<std::int64_t>(made + last_use[k] + 1, period);
    if (begin >= end) continue;
    ++change[static_cast<std::size_t>(begin)];
    --change[static_cast<std::size_t>(end)];
  }
  std::vector<std::uint32_t> counts(period);
  std::int64_t alive = 0;
  for (std::uint32_t k = 0; k < period; ++k) counts[k] = static_cast<std::uint32_t>(alive += change[k]);
  return counts;
}

// Loop rotation: a loop over operations begin..end-1, each of which matches the one a period later, rotated so that the
// fewest values are loop-carried. A body that splits a source iteration in the middle would carry its intermediate
// values, and passes could not simplify it (bodies.h).
Repeat rotated(Sequence const &sequence, std::uint32_t begin, std::uint32_t end, std::uint32_t period) {
  std::uint32_t const count = (end - begin) / period, spare = (end - begin) % period;
  Repeat best{begin, period, count};
  if (count < 3) return best;
  std::vector<std::uint32_t> const carried = crossings(sequence, begin + count / 2 * period, period);
  auto const rank = [&](std::uint32_t offset) { return std::tuple(carried[offset], offset > spare, offset); };
  std::uint32_t chosen = 0;
  for (std::uint32_t offset = 1; offset < period; ++offset) {
    Repeat const other{begin + offset, period, offset > spare ? count - 1 : count};
    if (rank(offset) < rank(chosen) && is_worth_it(sequence, other)) chosen = offset, best = other;
  }
  return best;
}

// Sequence position of operand i of operation p in iteration k.
std::uint32_t position_of(Sequence const &sequence, Repeat const &repeat, std::uint32_t k, std::uint32_t p,
                          unsigned i) {
  return sequence.position[sequence.operations[repeat.begin + k * repeat.period + p].operands[i].node];
}

bool is_inside(Repeat const &repeat, std::uint32_t k, std::uint32_t position) {
  return position != no_position && position >= repeat.begin + k * repeat.period && position < repeat.end();
}

// The first iteration that breaks the rule of trimmed(); nullopt if all comply.
std::optional<std::uint32_t> misfit(Sequence const &sequence, Repeat const &repeat) {
  for (std::uint32_t p = 0; p < repeat.period; ++p) {
    Operation const &first = sequence.operations[repeat.begin + p];
    for (unsigned i = 0; i < first.count; ++i) {
      std::uint32_t const inside = position_of(sequence, repeat, 0, p, i);
      bool const begins_inside = is_inside(repeat, 0, inside);
      for (std::uint32_t k = 1; k < repeat.count; ++k) {
        std::uint32_t const position = position_of(sequence, repeat, k, p, i);
        if (begins_inside ? position != inside + k * repeat.period : is_inside(repeat, k, position))
          return begins_inside ? k - 1 : k;
      }
    }
  }
  return {};
}

} // namespace

std::vector<std::uint64_t> window_hashes(std::vector<std::uint64_t> const &tokens, std::size_t window) {
  constexpr std::uint64_t base = 0x9E3779B97F4A7C15, spread = 0xD6E8FEB86659FD93;
  std::uint64_t leaving = 1, hash = 0;
  for (std::size_t k = 0; k + 1 < window; ++k) leaving *= base;
  auto const word = [&](std::size_t k) { return (tokens[k] ^ tokens[k] >> 29) * spread + 1; };
  std::vector<std::uint64_t> hashes;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    if (k >= window) hash -= word(k - window) * leaving;
    hash = hash * base + word(k);
    if (k + 1 >= window) hashes.push_back(hash);
  }
  return hashes;
}

std::vector<Repeat> find_repeats(Sequence const &sequence, std::vector<Repeat> const &known) {
  std::priority_queue<Stretch> stretches;
  for (std::uint32_t period : likely_periods(sequence)) add_stretches(sequence, period, stretches);
  std::map<std::uint32_t, Repeat> chosen; // by their ends
  for (Repeat const &repeat : known)
    if (matches(sequence, repeat)) chosen.emplace(repeat.end(), repeat);
  while (!stretches.empty()) {
    Stretch stretch = stretches.top();
    stretches.pop();
    // An overlapped stretch keeps the parts outside the better one.
    auto const over = chosen.upper_bound(stretch.begin);
    if (over != chosen.end() && over->second.begin < stretch.end) {
      Stretch const before{stretch.begin, std::max(over->second.begin, stretch.begin), stretch.period};
      Stretch const after{std::min(over->second.end(), stretch.end), stretch.end, stretch.period};
      for (Stretch const &rest : {before, after})
        if (is_worth_it(sequence, rest.repeat())) stretches.push(rest);
      continue;
    }
    Repeat const repeat = rotated(sequence, stretch.begin, stretch.end, stretch.period);
    chosen.emplace(repeat.end(), repeat);
  }
  std::vector<Repeat> repeats;
  for (auto const &[end, repeat] : chosen) repeats.push_back(repeat);
  return repeats;
}

void align(Sequence &sequence, std::vector<Repeat> const &repeats) {
  for (Repeat const &repeat : repeats)
    for (std::uint32_t at = repeat.begin; at + repeat.period < repeat.end(); ++at) {
      auto &operands = sequence.operations[at + repeat.period].operands;
      if (match(sequence, at, repeat.period) == Match::exchanged) std::swap(operands[0], operands[1]);
    }
}

std::vector<Repeat> trimmed(Sequence const &sequence, std::vector<Repeat> const &repeats) {
  std::vector<Repeat> kept;
  for (Repeat const &whole : repeats) {
    Repeat repeat = whole;
    while (repeat.count >= least_count) {
      std::optional<std::uint32_t> const bad = misfit(sequence, repeat);
      if (!bad) break;
      if (*bad < repeat.count / 2) {
        repeat.begin += (*bad + 1) * repeat.period;
        repeat.count -= *bad + 1;
      } else {
        repeat.count = *bad;
      }
    }
    if (repeat.count == whole.count || is_worth_it(sequence, repeat)) kept.push_back(repeat);
  }
  return kept;
}

} // namespace symreal::reroll
