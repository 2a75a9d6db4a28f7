// Figures of a partition into blocks: its balance, and the values that cross between blocks.
#pragma once

#include "engine/analysis/blocks/partition.h"

#include <optional>

namespace symreal {

struct BlockFigures {
  std::vector<std::size_t> operations; // per block: tasks of nonzero duration
  std::vector<Time> work;              // per block
  double balance = 1;                  // the largest work relative to the mean
  std::size_t cut = 0;                 // dependencies between tasks of two blocks
  std::size_t volume = 0;              // values that cross, counted once per receiving block
  std::size_t hand_overs = 0;          // the most on any path
  std::optional<std::size_t> depth;    // longest chain of blocks; nullopt for a cycle
};
BlockFigures block_figures(TaskGraph const &graph, Blocks const &blocks);

// Length of the longest path if each step to another block takes `hand_over`.
Time span_of_blocks(TaskGraph const &graph, Blocks const &blocks, Time hand_over);

// Length of the schedule in which each block executes its tasks in the order of the graph.
Time length_in_order(TaskGraph const &graph, Blocks const &blocks, Time hand_over);

} // namespace symreal
