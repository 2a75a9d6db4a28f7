// How the rewritten text spells the number and the macros around it.
//
// The rewriter writes its own words in their long form, SYMREAL_REAL and SYMREAL_REAL_VALUE(...), which no source has.
// Only in the end they get the name that was asked for, or the usual one where it is free: REAL and REAL_VALUE(...).
// Under any other name the macros keep their long form.
#pragma once

#include "rewrite/facts/facts.h"

#include <set>
#include <string>

namespace symreal::rewrite {

// The name to use; reports what takes a name that was asked for, and names that are ours alone.
std::string choose_type_name(Request const &request, Facts const &facts, std::vector<Diagnostic> &diagnostics);

// The text with the long forms in it replaced.
std::string with_type_name(std::string const &text, std::string const &type_name);

// Names that symbolic mode has others for: keywords of C++ (keyword_names.h) wherever they stand, and those of
// functions, variables and types at file scope (c_names.h), which members may have as well.
struct RenamedNames {
  std::set<std::string> all;
  std::set<std::string> at_file_scope;
};

// The text with each of them in it renamed, but for literals.
std::string with_renamed(std::string const &text, RenamedNames const &names);

} // namespace symreal::rewrite
