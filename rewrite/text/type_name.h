// Spelling of the number type and its macros in the rewritten text.
//
// The rewriter writes the long forms, SYMREAL_REAL and SYMREAL_REAL_VALUE(...), which sources do not contain. The last
// step replaces them by the requested name, or by the usual one if it is free: REAL and REAL_VALUE(...). Under any
// other name the macros keep their long form.
#pragma once

#include "rewrite/facts/facts.h"

#include <set>
#include <string>

namespace symreal::rewrite {

// Selects the name to use; reports a requested name that is taken, and uses of reserved names.
std::string choose_type_name(Request const &request, Facts const &facts, std::vector<Diagnostic> &diagnostics);

// The text with the long forms in it replaced.
std::string with_type_name(std::string const &text, std::string const &type_name);

// Names that symbolic mode has others for: keywords of C++ (token_watch.h) wherever they stand, and those of
// functions, variables and types at file scope (c/names.cpp), which members may have as well.
struct RenamedNames {
  std::set<std::string> all;
  std::set<std::string> at_file_scope;
};

// The text with each of them in it renamed, but for literals.
std::string with_renamed(std::string const &text, RenamedNames const &names);

} // namespace symreal::rewrite
