// What blocks are worth: how even they are, and what crosses between them.
#pragma once

#include "engine/analysis/blocks/partition.h"

#include <optional>

namespace symreal {

struct BlockFigures {
  std::vector<std::size_t> operations; // per block: tasks that last some time
  std::vector<Time> work;              // per block
  double balance = 1;                  // the largest work against the mean
  std::size_t cut = 0;                 // dependencies between tasks of two blocks
  std::size_t volume = 0;              // values that cross, each once for every block that receives it
  std::size_t hand_overs = 0;          // one after the other: the most on any path
  std::optional<std::size_t> depth;    // blocks one after the other, if no two wait for each other
};
BlockFigures block_figures(TaskGraph const &graph, Blocks const &blocks);

// The longest path, on which each step to another block takes `hand_over`.
Time span_of_blocks(TaskGraph const &graph, Blocks const &blocks, Time hand_over);

// How long it takes if each block does its tasks one after the other, in the order of the graph.
Time length_in_order(TaskGraph const &graph, Blocks const &blocks, Time hand_over);

} // namespace symreal
