// Printing of a function with vectors: vector statements interleaved with scalar ones.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"

namespace symreal {

CodeText print_lanes(Emission &emission, lanes::LaneFunction const &function);

} // namespace symreal
