// Copy steps: from one element of memory to another, or to an output.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/memory.h"

namespace symreal::reroll {

// Nodes to copy and their target elements: in memory, or in the outputs of the function.
struct Copies {
  std::vector<NodeId> nodes;
  std::vector<std::uint32_t> places;
  bool are_results;
};

// Adds the copies; as loops where sources and targets advance by constant steps.
void add_copies(Graph const &graph, Copies const &copies, Memory const &memory, std::vector<Step> &steps);

// Adds the last steps of a function. `done`: per result whether a step has stored it (direct_results.h).
void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> const &done,
                       Memory const &memory, std::vector<Step> &steps);

} // namespace symreal::reroll
