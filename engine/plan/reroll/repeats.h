// Repeats: stretches of a sequence that consist of copies of one window of operations.
//
// Two operations match over a period if they are the same operation, their operands are of the same kind (constant,
// input, read, computed), and each computed operand is equally far back, or the same node, or outside the period. Then
// one iteration of a loop can compute either; operands that vary come from tables.
#pragma once

#include "engine/plan/nest.h"
#include "engine/plan/reroll/sequence.h"

namespace symreal::reroll {

struct Repeat {
  std::uint32_t begin, period, count;
  std::optional<Nest> rows = {}; // loop nest of rows of chains (interchange.h)
  std::uint32_t end() const { return begin + period * count; }
};

// Least number of iterations of a loop.
inline constexpr std::uint32_t least_count = 4;

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

// Per token, the hash of the `window` tokens from it on, except near the end. Method: Karp-Rabin rolling hash.
std::vector<std::uint64_t> window_hashes(std::vector<std::uint64_t> const &tokens, std::size_t window);

// Disjoint repeats, in order. Repeats in `known` win if all of their operations match, then longer stretches, then
// shorter periods. Takes the time of a few dozen scans of the sequence.
std::vector<Repeat> find_repeats(Sequence const &sequence, std::vector<Repeat> const &known);

// Exchanges operands so that each iteration has them in the order of the one before.
void align(Sequence &sequence, std::vector<Repeat> const &repeats);

// Trims aligned repeats. An operand of an iteration must be computed before that iteration, or by the same operation of
// its body in every iteration. The iterations from the first violation on, or those up to it, are left out.
std::vector<Repeat> trimmed(Sequence const &sequence, std::vector<Repeat> const &repeats);

} // namespace symreal::reroll
