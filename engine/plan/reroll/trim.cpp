#include "engine/plan/reroll/trim.h"

#include <optional>

namespace symreal::reroll {

namespace {

// Sequence position of operand i of operation p in iteration k.
std::uint32_t position_of(Sequence const &sequence, Repeat const &repeat, std::uint32_t k, std::uint32_t p,
                          unsigned i) {
  return sequence.position[sequence.operations[repeat.begin + k * repeat.period + p].operands[i].node];
}

bool is_inside(Repeat const &repeat, std::uint32_t k, std::uint32_t position) {
  return position != no_position && position >= repeat.begin + k * repeat.period && position < repeat.end();
}

// The first iteration that breaks the rule in trim.h; nullopt if all comply.
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
