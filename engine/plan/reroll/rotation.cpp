#include "engine/plan/reroll/rotation.h"

#include <algorithm>
#include <tuple>

namespace symreal::reroll {

namespace {

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

} // namespace

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

} // namespace symreal::reroll
