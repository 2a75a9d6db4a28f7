// Check that numeric mode is the original: compiles sources before and after rewriting with the same flags and compares
// the object code, without symbol and debug tables.
#pragma once

#include "program/build/workspace.h"
#include "rewrite/rewrite.h"

#include <string>
#include <vector>

namespace symreal::program {

// Compilers by the extension of a source; empty: the compiler of the source's own build, else cc and c++.
struct Compilers {
  std::string c, cxx;
};

struct ObjectComparison {
  std::size_t compared = 0, identical = 0;
  std::vector<Diagnostic> diagnostics; // numeric_difference, build_failed
};

// Compares all sources; `jobs` compilers run at once.
ObjectComparison compare_object_code(std::vector<rewrite::Compilation> const &sources, rewrite::Result const &rewritten,
                                     Compilers const &compilers, unsigned jobs, Workspace const &workspace);

} // namespace symreal::program
