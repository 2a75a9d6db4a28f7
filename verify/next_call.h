// The program's own next call of a kernel: what the program changes between two calls, and the recording has baked in,
// shows there.
#pragma once

#include "runtime/replay/samples.h"
#include "verify/generated_code.h"
#include "verify/replay.h"
#include "verify/verification.h"

namespace symreal::program {

// Whether the next call must be the recorded one on other inputs: nothing is said to be constant, the recording has
// told of nothing that it bakes in, the clauses name every argument, and as many numbers have one shape.
bool is_next_call_comparable(Recorded const &recorded);

// `first`: the original in the recorded call. On how many of the samples the original gives other outputs there than
// the generated code. None where the program has no such call, or gives arguments in one place that lay apart.
std::size_t different_in_next_call(Front const &front, RunOptions const &run, Recorded const &recorded,
                                   GeneratedCode &code, Replay &first, std::string const &executable,
                                   std::vector<Sample> const &samples, double tolerance);

} // namespace symreal::program
