// Functions of the C library that take memory of any type.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

// The address of REAL objects may go there: the function moves bytes, which carry nodes as well as numbers, or it is
// watched (bits.cpp).
bool moves_bytes(clang::FunctionDecl const *function);

} // namespace symreal::rewrite
