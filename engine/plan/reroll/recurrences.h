// Recurrences of loops, and their reassociation for latency, for mode fast.
#pragma once

#include "engine/plan/loop_function.h"

namespace symreal::reroll {

// Loop-carried values that depend on one another: the next value of each needs those of all.
struct Recurrence {
  std::vector<std::uint32_t> leaves; // indices into the leaves of the step
  double period;                     // minimum time per iteration, in latencies of an addition
};
std::vector<Recurrence> recurrences(LoopStep const &step);

// Reassociates sums and products so that the value carried from the last iteration is used last: y = x - a*y + b*z,
// where y comes from the last iteration and z from an earlier one, becomes y = (x + b*z) - a*y. The operation count is
// unchanged. Returns the step unchanged if throughput, not latency, limits its iterations.
LoopStep with_short_recurrences(LoopStep step);

} // namespace symreal::reroll
