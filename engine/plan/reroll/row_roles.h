// Roles of operands in rows of chains.
//
// Rows of chains (interchange.h) form a loop nest: a row computes the same stages of all chains, side by side. A value
// that a chain hands from row to row has one element per chain, which each row overwrites.
#pragma once

#include "engine/plan/reroll/roles.h"

namespace symreal::reroll {

// Initial values of the chains, stored where later rows find the value of the body operation `position`.
struct Entry {
  std::uint32_t position;
  std::vector<NodeId> nodes; // per chain
};

// As choose_role; nullopt if the operand is determined neither by the chain nor by the row. Adds to `entries` the
// initial values to store before the loop.
std::optional<Role> choose_role_in_rows(Sequence const &sequence, std::vector<LoopBody> const &loops,
                                        std::uint32_t loop, Column const &column, Memory &memory,
                                        std::function<void(Cell const &, NodeId)> const &copy,
                                        std::vector<Entry> &entries);

} // namespace symreal::reroll
