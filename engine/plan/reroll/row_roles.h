// How the body of rows of chains finds the operands of a column.
//
// Rows of chains (interchange.h) are one loop in the other: a row does the same stages of all chains, side by side.
// What a chain hands on from row to row stays at one place for each chain, where it is overwritten.
#pragma once

#include "engine/plan/reroll/roles.h"

namespace symreal::reroll {

// What chains have before their first row, where they find afterwards what an operation of the body computes.
struct Entry {
  std::uint32_t position;
  std::vector<NodeId> nodes; // per chain
};

// As choose_role. None where neither a chain nor the row says what the operand is. Adds to `entries` what must stand
// there before the loop.
std::optional<Role> choose_role_in_rows(Sequence const &sequence, std::vector<LoopBody> const &loops,
                                        std::uint32_t loop, Column const &column, Memory &memory,
                                        std::function<void(Cell const &, NodeId)> const &copy,
                                        std::vector<Entry> &entries);

} // namespace symreal::reroll
