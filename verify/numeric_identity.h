// Numeric mode is the original: compiles sources before and after the rewriting with the same flags, and compares the
// object code, symbol and debugging tables aside.
#pragma once

#include "program/build/workspace.h"
#include "rewrite/rewrite.h"

#include <string>
#include <vector>

namespace symreal::program {

// By the ending of a source; an empty one: as the source's own build has it, else cc and c++.
struct Compilers {
  std::string c, cxx;
};

struct ObjectComparison {
  std::size_t compared = 0, identical = 0;
  std::vector<Diagnostic> diagnostics; // numeric_difference, build_failed
};

// So many compilers run at once.
ObjectComparison compare_object_code(std::vector<rewrite::Compilation> const &sources, rewrite::Result const &rewritten,
                                     Compilers const &compilers, unsigned jobs, Workspace const &workspace);

} // namespace symreal::program
