// The last steps of a function: from memory to what it fills, where no step has done it (direct_results.h).
#pragma once

#include "reroll/loop_program.h"
#include "reroll/memory.h"

namespace symreal::reroll {

// `done`: per result whether a step has stored it.
void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> done,
                       Memory const &memory, std::vector<Step> &steps);

} // namespace symreal::reroll
