// Pieces of a function: its loops, and the straight-line code between them.
#pragma once

#include "engine/plan/reroll/memory.h"
#include "engine/plan/reroll/roles.h"

#include <utility>

namespace symreal::reroll {

// A loop, or a piece of straight-line code.
struct Piece {
  std::uint32_t begin, end;
  std::uint32_t loop = no_position;
  std::vector<std::pair<Cell, NodeId>> copies = {}; // read by later loops
  std::vector<NodeId> kept = {};                    // nodes without an operation that are read from memory

  bool computes(Sequence const &sequence, NodeId node) const {
    return sequence.position[node] != no_position && sequence.position[node] >= begin && sequence.position[node] < end;
  }
};

// Pieces in order, with at least one straight piece before each loop and at the end.
std::vector<Piece> pieces(Sequence const &sequence, std::vector<LoopBody> const &loops);

// Whether the piece reads arrays that results may overlap. `roles`: per loop and column.
bool reads_arguments(Piece const &piece, Sequence const &sequence, std::vector<std::vector<Role>> const &roles);

} // namespace symreal::reroll
