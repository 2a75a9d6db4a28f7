// A wrapper where the caller gives other values than the recording has baked in: it must notice.
#pragma once

#include "runtime/replay/samples.h"
#include "verify/generated_code.h"
#include "verify/verification.h"

namespace symreal::program {

// `executable`: the original with its wrapper (program/wrapper/wrapped_original.h), which no process runs any more.
// Changes each value by itself, and runs it with and without the wrapper's statements on the samples. The values for
// which the results differ. What the original does not end on with such a value says nothing.
std::vector<LeftState> values_missed_by_wrapper(Front const &front, RunOptions const &run, Recorded const &recorded,
                                                Graph const &graph, GeneratedCode const &code,
                                                std::string const &executable, std::vector<Sample> const &samples,
                                                double tolerance);

} // namespace symreal::program
