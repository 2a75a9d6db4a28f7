// Roles: how the body of a loop accesses the operands of a column.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/memory.h"

#include <functional>

namespace symreal::reroll {

struct Role {
  Leaf::Kind kind = Leaf::Kind::values;
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
  std::uint32_t next = no_position;
  std::vector<NodeId> nodes = {};
};

// Role of one value per iteration: a constant, or a column of a table. `nest`: that of the iterations.
Role role_of_values(std::vector<double> const &values, std::optional<Nest> const &nest = {});

// Declares to memory what the column needs; `copy` puts a node into a cell before the loop.
Role choose_role(Sequence const &sequence, std::vector<LoopBody> const &loops, std::uint32_t loop, Column const &column,
                 Memory &memory, std::function<void(Cell const &, NodeId)> const &copy);

// Leaf for the role, after memory is laid out. `nest`: that of the loop.
Leaf leaf_of(Role const &role, Memory const &memory, std::optional<Nest> const &nest = {});

// Array that holds a node from this source; not for computed nodes.
Leaf::Kind array_of(Source source);

// Affine access if the elements fit, else a list.
Access access_of(std::vector<std::uint32_t> elements);

} // namespace symreal::reroll
