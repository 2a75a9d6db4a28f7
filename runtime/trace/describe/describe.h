// Expressions of the current recording in words a person can follow.
#pragma once

#include <symreal/symbolic.h>

#include <string>

namespace symreal::trace {

// Expression in C's notation with the annotations' labels for inputs and parameters; truncated with "...".
std::string describe(RealNumber number);
std::string describe(Op op, RealNumber x, RealNumber y);

} // namespace symreal::trace
