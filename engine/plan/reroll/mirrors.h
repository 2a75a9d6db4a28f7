// Symmetric matrices among the results: one half is computed, the other copied from it at the end.
//
// A loop over a half stores contiguously by rows or by columns, not both, so stores to the other half would each touch
// another cache line. The other half is therefore copied in blocks.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/memory.h"

namespace symreal::reroll {

// `objects`: objects whose elements the results `stored` are.
std::vector<Mirror> mirrors(std::vector<Object> const &objects, std::vector<NodeId> const &stored,
                            Memory const &memory);

// Calls visit(to, from) for each copied result and its source.
template <class Visit> void for_each_copy(Mirror const &mirror, Visit const &visit) {
  for (std::uint32_t row = 0; row < mirror.rows; ++row)
    for (std::uint32_t column = 0; column < row; ++column) {
      std::uint32_t const below = mirror.first + mirror.rows * row + column;
      std::uint32_t const above = mirror.first + mirror.rows * column + row;
      mirror.from_above ? visit(below, above) : visit(above, below);
    }
}

} // namespace symreal::reroll
