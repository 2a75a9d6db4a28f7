// Numeric mode is the original: compiles sources before and after the rewriting with the same flags, and compares the
// object code, symbol and debugging tables aside.
#pragma once

#include "program/workspace.h"
#include "rewrite/rewrite.h"

#include <string>
#include <vector>

namespace symreal::program {

struct Compilers {
  std::string c = "cc", cxx = "c++"; // by the ending of a source
};

struct ObjectComparison {
  std::size_t compared = 0, identical = 0;
  std::vector<Diagnostic> diagnostics; // numeric_difference, build_failed
};

ObjectComparison compare_object_code(std::vector<rewrite::Compilation> const &sources, rewrite::Result const &rewritten,
                                     Compilers const &compilers, Workspace const &workspace);

} // namespace symreal::program
