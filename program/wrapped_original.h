// A program that tries a wrapper: the original, where the kernel's function first does what the wrapper does, and goes
// on with its own statements only where a guard does not hold.
#pragma once

#include "program/front.h"

namespace symreal::program {

// Does the wrapper's file have the statements that belong to this kernel?
bool is_wrapper_of(std::string const &text, Recorded const &recorded);

// The executable. For kernels of functions.
std::string build_wrapped(Front const &front, Recorded const &recorded);

} // namespace symreal::program
