// What was recorded of a kernel, as its main program needs it.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// "y[0]", "m[1][0]": each output, in order.
std::vector<std::string> output_names(Emission const &emission);

// Each number in the language.
std::vector<std::string> constants(Language const &language, std::vector<double> const &values);

} // namespace symreal
