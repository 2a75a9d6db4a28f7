// Verification that a wrapper notices values other than those that the recording has baked in.
#pragma once

#include "runtime/replay/samples.h"
#include "verify/generated_code.h"
#include "verify/verification.h"

namespace symreal::program {

// Returns the values whose change gives different results with and without the wrapper's statements; changes one value
// at a time, on the samples. `executable`: the original with its wrapper (program/wrapper/wrapped_original.h), which no
// process runs any more. Values on which the original does not end are skipped.
std::vector<LeftState> values_missed_by_wrapper(Front const &front, RunOptions const &run, Recorded const &recorded,
                                                Graph const &graph, GeneratedCode const &code,
                                                std::string const &executable, std::vector<Sample> const &samples,
                                                double tolerance);

} // namespace symreal::program
