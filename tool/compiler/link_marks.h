// Law 4 at link time. A name with C linkage, or one that only mentions REAL in a class, is the same in numeric and in
// symbolic mode, so a library that works on double would be linked without a word. Therefore each object defines a mark
// for each function on REAL that it defines, and refers to the mark of each one that it uses from elsewhere: where only
// a numeric object defines the function, the mark stays undefined.
#pragma once

#include "rewrite/rewrite.h"

#include <set>
#include <string>

namespace symreal::compiler {

// To stand at the end of the rewritten source.
std::string link_marks(rewrite::Result const &rewritten);

// The functions whose marks the linker misses, by its messages.
std::set<std::string> missing_marks(std::string const &linker_output);

} // namespace symreal::compiler
