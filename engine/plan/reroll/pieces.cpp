#include "engine/plan/reroll/pieces.h"

#include <algorithm>
#include <ranges>

namespace symreal::reroll {

namespace {

constexpr std::uint32_t most_operations = 1000; // of a straight piece: compilation time is superlinear in function size

} // namespace

std::vector<Piece> pieces(Sequence const &sequence, std::vector<LoopBody> const &loops) {
  std::vector<Piece> pieces;
  std::uint32_t at = 0;
  auto const straight_to = [&](std::uint32_t end) {
    do {
      std::uint32_t const next = std::min(at + most_operations, end);
      pieces.push_back({at, next});
      at = next;
    } while (at < end);
  };
  for (std::uint32_t loop = 0; loop < loops.size(); ++loop) {
    Repeat const &repeat = loops[loop].repeat;
    straight_to(repeat.begin);
    pieces.push_back({repeat.begin, repeat.end(), loop});
    at = repeat.end();
  }
  straight_to(static_cast<std::uint32_t>(sequence.size()));
  return pieces;
}

bool reads_arguments(Piece const &piece, Sequence const &sequence, std::vector<std::vector<Role>> const &roles) {
  if (piece.loop != no_position) return std::ranges::any_of(roles[piece.loop], is_argument, &Role::kind);
  auto const is_given = [&](NodeId node) {
    Source const source = sequence.source(node);
    return source != Source::computed && source != Source::constant && is_argument(array_of(source));
  };
  for (std::uint32_t at = piece.begin; at < piece.end; ++at)
    for (unsigned i = 0; i < sequence.operations[at].count; ++i)
      if (is_given(sequence.operations[at].operands[i].node)) return true;
  return std::ranges::any_of(piece.copies | std::views::values, is_given) || std::ranges::any_of(piece.kept, is_given);
}

} // namespace symreal::reroll
