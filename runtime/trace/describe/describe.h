// Expressions of the current recording in words a person can follow.
#pragma once

#include <symreal/symbolic.h>

#include <string>

namespace symreal::trace {

// In C's notation with the annotations' labels for inputs and parameters; cut off with "..." where it gets long.
std::string describe(RealNumber number);
std::string describe(Op op, RealNumber x, RealNumber y);

} // namespace symreal::trace
