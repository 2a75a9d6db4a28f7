// Link of a symbolic program, and link marks, which keep symbolic code from linking with numeric code. Names with C
// linkage, and names that mention REAL only within a class, are equal in both modes, so a library on double would be
// linked silently. Therefore an object defines a mark for each function on REAL that it defines, and refers to the mark
// of each that it uses from elsewhere: if only a numeric object defines the function, the mark stays undefined.
#pragma once

#include "rewrite/rewrite.h"
#include "tool/compiler/command_line.h"

#include <string>

namespace symreal::compiler {

// Text of the marks, to append to the rewritten source.
std::string link_marks(rewrite::Result const &rewritten);

// Links a symbolic program with its runtime; returns the exit status.
int link(Words const &compiler, Words words);

} // namespace symreal::compiler
