// The parts of generated Rust, one function each.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// Sizes, where objects begin, the mathematical library, integers.
std::string rust_begin(Emission const &emission);
// The integer functions that the kernel's functions call.
std::string rust_integer_functions(Emission const &emission);
// With guards: the function that gives their texts.
std::string rust_end(Emission const &emission);
std::string rust_mainline(Emission const &emission);

} // namespace symreal
