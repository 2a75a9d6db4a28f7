// Check of the program's own next call of a kernel: exposes baked-in values that the program changes between calls.
#pragma once

#include "runtime/replay/samples.h"
#include "verify/generated_code.h"
#include "verify/replay.h"
#include "verify/verification.h"

namespace symreal::program {

// Must the next call be the recorded one on other inputs? True if nothing is declared constant or reported as baked in,
// the clauses name every argument, and the number of inputs determines their shapes.
bool is_next_call_comparable(Recorded const &recorded);

// Number of samples on which the original's outputs in the next call differ from the generated code's. `first`: the
// original in the recorded call. 0 if the program makes no such call, or passes overlapping arguments that lay apart.
std::size_t different_in_next_call(Front const &front, RunOptions const &run, Recorded const &recorded,
                                   GeneratedCode &code, Replay &first, std::string const &executable,
                                   std::vector<Sample> const &samples, double tolerance);

} // namespace symreal::program
