// The sines and cosines that function compute begins with.
#pragma once

#include "emit/print/code_text.h"
#include "emit/print/emission.h"

namespace symreal {

// Nothing where there are none. Reads array `input`, and declares and fills arrays `sine` and `cosine`.
void print_angles(Emission const &emission, CodeText &out);

} // namespace symreal
