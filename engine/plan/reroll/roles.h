// Roles: how the body of a loop accesses the operands of a column.
//
// Rows of chains (interchange.h) form a loop nest: a row computes the same stages of all chains, side by side. A value
// that a chain hands from row to row has one element per chain, which each row overwrites.
#pragma once

#include "engine/plan/reroll/memory.h"

#include <functional>

namespace symreal::reroll {

struct Role {
  Array array = Array::values;
  std::optional<double> constant = {}; // of values that are all equal
  std::vector<double> values = {};     // one period of them, if they differ
  bool by_turn = false;                // one value, or element, per turn of the outer loop
  Access access = {};                  // in the input of the function, or the array that it reads
  // In memory: cells with a constant step of iterations, one node, or a list.
  std::optional<Cell> cell = {};
  std::int64_t step = 0;
  bool in_chain = false; // computed by the row before: the cell gives the operation
  NodeId node = no_node;
  // A loop-carried value: the body operation that computes it, and in `nodes` its values in the first iterations,
  // one for each iteration that it is carried over.
  bool is_carried = false;
  std::uint32_t next = no_position;
  std::vector<NodeId> nodes = {};
};

// Initial values of the chains, stored where later rows find the value of the body operation `position`.
struct Entry {
  std::uint32_t position;
  std::vector<NodeId> nodes; // per chain
};

// Role of one value per iteration: a constant, or a column of a table. `nest`: that of the iterations.
Role role_of_values(std::vector<double> const &values, std::optional<Nest> const &nest = {});

using Copy = std::function<void(Cell const &, NodeId)>;

// Role of an operand of the loop; nullopt if it is in rows of chains, and neither the chain nor the row determines it.
// Declares to memory what the column needs; `copy` puts a node into a cell before the loop. Adds to `entries` the
// initial values to store before the loop.
std::optional<Role> choose_role(Sequence const &sequence, std::vector<LoopBody> const &loops, std::uint32_t loop,
                                Column const &column, Memory &memory, Copy const &copy, std::vector<Entry> &entries);

// Leaf for the role, after memory is laid out. `nest`: that of the loop.
Leaf leaf_of(Role const &role, Memory const &memory, std::optional<Nest> const &nest = {});

} // namespace symreal::reroll
