// Stretches of a sequence in which the same operations follow each other again and again.
//
// Two operations match over a period if they are the same, their operands are of the same kind (constant, input, read,
// computed), and what they compute with stands equally far back, or is the same node, or lies outside the period. Then
// an iteration of a loop can compute either, whatever its operands are: what varies is a matter of tables.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/sequence.h"

namespace symreal::reroll {

struct Repeat {
  std::uint32_t begin, period, count;
  std::optional<Nest> rows = {}; // of chains that are computed side by side: see interchange.h
  std::uint32_t end() const { return begin + period * count; }
};

// Whether an operation matches another one, and whether its first two operands must be exchanged for that. `fit`:
// whether an operand may stand where one of the other stands.
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

// The operation at `at` and the one a period later.
Match match(Sequence const &sequence, std::uint32_t at, std::uint32_t period);

// What is worth a loop: so many iterations; so many operations that need no code then, and this part of all or so many
// that the part does not matter. Small loops inside of straight-line code cost more than they save.
inline constexpr std::uint32_t least_count = 4, least_saving = 24, least_part = 50, ample_saving = 300;
bool is_worth_it(Sequence const &sequence, Repeat const &repeat);

// Disjoint, in order. Those that are `known` win if all of their operations match, then the longest stretches, of equal
// ones those of the shorter period. Time is that of a few dozen scans of the sequence.
std::vector<Repeat> find_repeats(Sequence const &sequence, std::vector<Repeat> const &known = {});

// Exchanges operands so that those of an iteration stand as those of the one before.
void align(Sequence &sequence, std::vector<Repeat> const &repeats);

} // namespace symreal::reroll
