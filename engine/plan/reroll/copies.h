// Steps that copy: from one place of memory to another, or to what the function fills.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/memory.h"

namespace symreal::reroll {

// What stands where afterwards, one by one: in memory, or of what the function fills.
struct Copies {
  std::vector<NodeId> nodes;
  std::vector<std::uint32_t> places;
  bool are_results;
};

// As loops where both ends are a step apart.
void add_copies(Graph const &graph, Copies const &copies, Memory const &memory, std::vector<Step> &steps);

// The last steps of a function. `done`: per result whether a step has stored it (direct_results.h).
void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> const &done,
                       Memory const &memory, std::vector<Step> &steps);

} // namespace symreal::reroll
