// How long an iteration waits for the one before: for mode fast.
#pragma once

#include "engine/plan/reroll/loop_program.h"

namespace symreal::reroll {

// Values that are carried on and depend on one another: the next value of each needs those of all.
struct Recurrence {
  std::vector<std::uint32_t> leaves; // their places among those of the step
  double period;                     // the least time from one iteration to the next, in additions
};
std::vector<Recurrence> recurrences(Step const &step);

// A loop whose sums and products take last what the iteration before has computed last: y = x - a*y + b*z, where y
// comes from the iteration before and z from an earlier one, becomes y = (x + b*z) - a*y. The work is the same. A step
// as it is where that does not help: where the processor has more to do in an iteration than it waits for.
Step with_short_recurrences(Step step);

} // namespace symreal::reroll
