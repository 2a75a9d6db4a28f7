// From repeats to steps.
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// `stored`: what the function fills, element by element, which are those of `objects`, if they have names. `checked`:
// what must not be 0 for that. None where rows of chains (interchange.h) hand on something else than they may.
std::optional<LoopFunction> plan(Sequence sequence, std::vector<Repeat> const &repeats,
                                 std::vector<NodeId> const &stored, std::vector<NodeId> const &checked,
                                 std::vector<Object> const &objects = {});

} // namespace symreal::reroll
