// Construction of steps: of straight pieces, and of loops whose operands have roles.
#pragma once

#include "engine/plan/reroll/direct_results.h"
#include "engine/plan/reroll/pieces.h"

namespace symreal::reroll {

// `results`: per operation the results that the step stores directly.
Step straight_step(Piece const &piece, Sequence const &sequence, Memory const &memory,
                   std::map<NodeId, std::vector<std::uint32_t>> const &results);

// `loop`: its number in memory. `roles`: of its columns. `results`: those that the loop stores directly.
Step loop_step(std::uint32_t loop, LoopBody const &plan, std::vector<Role> const &roles, Graph const &graph,
               Memory const &memory, std::vector<LoopResult> const &results);

} // namespace symreal::reroll
