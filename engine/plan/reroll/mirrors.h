// Symmetric matrices among the results: one half is computed, the other copied from it when all else is done.
//
// Of the elements of a half that a loop computes, only the rows, or only the columns, stand beside each other. Stores
// to the other half go to another cache line each; so it is copied in blocks.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/memory.h"

namespace symreal::reroll {

// `objects`: what the results `stored` are elements of.
std::vector<Mirror> mirrors(std::vector<Object> const &objects, std::vector<NodeId> const &stored,
                            Memory const &memory);

// Calls visit(to, from) for each result that is copied and the one that it is copied from.
template <class Visit> void for_each_copy(Mirror const &mirror, Visit const &visit) {
  for (std::uint32_t row = 0; row < mirror.rows; ++row)
    for (std::uint32_t column = 0; column < row; ++column) {
      std::uint32_t const below = mirror.first + mirror.rows * row + column;
      std::uint32_t const above = mirror.first + mirror.rows * column + row;
      mirror.from_above ? visit(below, above) : visit(above, below);
    }
}

} // namespace symreal::reroll
