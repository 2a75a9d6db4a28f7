// Repeats: stretches of a sequence that consist of copies of one window of operations.
//
// Two operations match over a period if they are the same operation, their operands are of the same kind (constant,
// input, read, computed), and each computed operand is equally far back, or the same node, or outside the period. Then
// one iteration of a loop can compute either; operands that vary come from tables.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/sequence.h"

namespace symreal::reroll {

struct Repeat {
  std::uint32_t begin, period, count;
  std::optional<Nest> rows = {}; // loop nest of rows of chains (interchange.h)
  std::uint32_t end() const { return begin + period * count; }
};

// Whether two operations match, and whether the first two operands must be exchanged for that. `fit`: whether one
// operand may take the place of another.
enum class Match { none, as_is, exchanged };
template <typename Fit> Match match(Operation const &a, Operation const &b, Fit fit) {
  if (a.op != b.op || a.count != b.count) return Match::none;
  bool as_is = true;
  for (unsigned i = 0; i < a.count; ++i) as_is = as_is && fit(a.operands[i].node, b.operands[i].node);
  if (as_is) return Match::as_is;
  bool const crosswise =
      a.may_exchange && fit(a.operands[0].node, b.operands[1].node) && fit(a.operands[1].node, b.operands[0].node);
  return crosswise ? Match::exchanged : Match::none;
}

// Match of the operation at `at` and the one a period later.
Match match(Sequence const &sequence, std::uint32_t at, std::uint32_t period);

// Thresholds for a loop: iterations; operations that it saves, and their percentage of the function, or a saving that
// suffices at any percentage. Small loops inside straight-line code cost more than they save.
inline constexpr std::uint32_t least_count = 4, least_saving = 24, least_part = 50, ample_saving = 300;
bool is_worth_it(Sequence const &sequence, Repeat const &repeat);

// Disjoint repeats, in order. Repeats in `known` win if all of their operations match, then longer stretches, then
// shorter periods. Takes the time of a few dozen scans of the sequence.
std::vector<Repeat> find_repeats(Sequence const &sequence, std::vector<Repeat> const &known = {});

// Exchanges operands so that each iteration has them in the order of the one before.
void align(Sequence &sequence, std::vector<Repeat> const &repeats);

} // namespace symreal::reroll
