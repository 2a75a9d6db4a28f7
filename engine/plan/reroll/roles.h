// How the body of a loop finds the operands of a column.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/memory.h"

#include <functional>

namespace symreal::reroll {

struct Role {
  Leaf::Kind kind = Leaf::Kind::values;
  std::optional<double> constant = {}; // of values that are all the same
  std::vector<double> values = {};     // otherwise their period
  bool by_turn = false;                // one value, or element, for each turn of the outer of two loops
  Access access = {};                  // in what the function is given or reads
  // In memory: cells a step of iterations apart, or one node, or a list.
  std::optional<Cell> cell = {};
  std::int64_t step = 0;
  bool in_chain = false; // of what the row before computes: the cell says which operation
  NodeId node = no_node;
  // Of what is carried on, the operation of the body that computes it, and in `nodes` its values in the first
  // iterations: as many as it is carried.
  std::uint32_t next = no_position;
  std::vector<NodeId> nodes = {};
};

// A constant, or a column of a table: of these values, one for each iteration. `nest`: whose iterations they are.
Role role_of_values(std::vector<double> const &values, std::optional<Nest> const &nest = {});

// Says to memory what the column needs; `copy` puts a node into a cell before the loop.
Role choose_role(Sequence const &sequence, std::vector<LoopBody> const &loops, std::uint32_t loop, Column const &column,
                 Memory &memory, std::function<void(Cell const &, NodeId)> const &copy);

// Once memory is laid out. `nest`: whose iterations the loop has.
Leaf leaf_of(Role const &role, Memory const &memory, std::optional<Nest> const &nest = {});

// The array that such a node, which no operation computes, is an element of.
Leaf::Kind array_of(Source source);

// As first and step, if they fit.
Access access_of(std::vector<std::uint32_t> elements);

} // namespace symreal::reroll
