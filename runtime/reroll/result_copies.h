// The last steps of a function: from memory to what it fills.
#pragma once

#include "reroll/loop_program.h"
#include "reroll/memory.h"

namespace symreal::reroll {

void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, Memory const &memory,
                       std::vector<Step> &steps);

} // namespace symreal::reroll
