// Printing of the sines and cosines at the start of compute.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"

namespace symreal {

// Array of computed angles, and the function that fills it.
inline constexpr char const *computed_angles = "computed_angle";
std::string angles_function(Emission const &emission);

// Declares and fills arrays `sine` and `cosine`, if there are angles. Reads array `input`, and for computed angles also
// `constants`.
void print_angles(Emission const &emission, CodeText &out);

} // namespace symreal
