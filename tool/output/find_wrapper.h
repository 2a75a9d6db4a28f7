// Wrapper of a generated file: the file beside it, or the copies, that take the place of its kernel's function.
#pragma once

#include "program/record/front.h"

#include <string>

namespace symreal::tool {

// Is there a wrapper of this kernel, of code with this prefix? Throws foreign_file for one of another form of it.
bool has_wrapper(program::Front &front, program::RunOptions const &run, std::string const &generated,
                 std::string const &prefix, program::Recorded const &recorded);

} // namespace symreal::tool
