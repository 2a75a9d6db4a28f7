// From repeats to steps.
#pragma once

#include "reroll/loop_program.h"
#include "reroll/repeats.h"

namespace symreal::reroll {

// `stored`: what the function fills, element by element. `checked`: what must not be 0 for that.
LoopFunction plan(Sequence sequence, std::vector<Repeat> const &repeats, std::vector<NodeId> const &stored,
                  std::vector<NodeId> const &checked);

} // namespace symreal::reroll
