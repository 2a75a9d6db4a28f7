// Recorded values and names of a kernel, for its main program.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// Name of each output, in order: "y[0]", "m[1][0]".
std::vector<std::string> output_names(Emission const &emission);

// Each number as a literal of the language.
std::vector<std::string> constants(Language const &language, std::vector<double> const &values);

} // namespace symreal
