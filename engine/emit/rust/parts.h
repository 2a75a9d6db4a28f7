// The parts of generated Rust, one function each.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// Sizes, object offsets, the mathematical library, integer functions.
std::string rust_begin(Emission const &emission);
// Integer functions that the kernel's functions call.
std::string rust_integer_functions(Emission const &emission);
// Function that returns the texts of guards, if there are guards.
std::string rust_end(Emission const &emission);
std::string rust_mainline(Emission const &emission);

} // namespace symreal
