// Planning of loops: the steps of a function, which are its repeats as loops and the straight pieces between them.
#pragma once

#include "engine/plan/loop_function.h"
#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// `stored`: values of the outputs, element by element, in the order of `objects` if that is given. `checked`: guards,
// which must be nonzero. Returns nullopt if rows of chains (interchange.h) hand on values in an unsupported way.
std::optional<LoopFunction> plan(Sequence sequence, std::vector<Repeat> const &repeats,
                                 std::vector<NodeId> const &stored, std::vector<NodeId> const &checked,
                                 std::vector<Object> const &objects);

} // namespace symreal::reroll
