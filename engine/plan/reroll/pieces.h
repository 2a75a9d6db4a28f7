// The operations of a function as loops and the straight stretches between them.
#pragma once

#include "engine/plan/reroll/memory.h"
#include "engine/plan/reroll/roles.h"

#include <utility>

namespace symreal::reroll {

// A loop, or a straight stretch.
struct Piece {
  std::uint32_t begin, end;
  std::uint32_t loop = no_position;
  std::vector<std::pair<Cell, NodeId>> copies = {}; // that later loops read
  std::vector<NodeId> kept = {};                    // what no operation computes and is read from memory

  bool computes(Sequence const &sequence, NodeId node) const {
    return sequence.position[node] != no_position && sequence.position[node] >= begin && sequence.position[node] < end;
  }
};

// One straight piece or more before each loop, and at the end.
std::vector<Piece> pieces(Sequence const &sequence, std::vector<LoopBody> const &loops);

// Whether it reads what results may overlap with. `roles`: per loop and column.
bool reads_arguments(Piece const &piece, Sequence const &sequence, std::vector<std::vector<Role>> const &roles);

} // namespace symreal::reroll
