// A function some of whose operations are computed side by side: statements of vectors among those of numbers.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"

namespace symreal {

CodeText print_lanes(Emission &emission, lanes::LaneFunction const &function);

} // namespace symreal
