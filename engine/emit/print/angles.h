// The sines and cosines that function compute begins with.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"

namespace symreal {

// The array of angles that are computed, and the function that fills it.
inline constexpr char const *computed_angles = "computed_angle";
std::string angles_function(Emission const &emission);

// Nothing where there are none. Reads array `input`, for angles that are computed also `constants`, and declares and
// fills arrays `sine` and `cosine`.
void print_angles(Emission const &emission, CodeText &out);

} // namespace symreal
