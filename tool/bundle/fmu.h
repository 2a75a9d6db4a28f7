// A kernel as a functional mock-up unit of FMI 3.0, for model exchange and co-simulation.
#pragma once

#include "tool/options/code_options.h"

#include <string>

namespace symreal::tool {

// Bytes of a unit. The sources omit the original's mathematical library, so that the graph's text determines them.
// Throws bad_option for a kernel without states.
std::string unit_bytes(Plan const &plan, EmitterOptions const &emitter, FloatingPoint mode);

} // namespace symreal::tool
