// Sources in C are compiled as C++ in symbolic mode, but which of their lines are compiled, and what their macros stand
// for, is told by C: `#ifdef __cplusplus` is false, also in a header of theirs, while the system's headers are those of
// C++. So a name that a directive of theirs asks about, and that C++ has another answer for, becomes a name of its own
// in their files, `symreal_c_NAME`, with what C knows about it.
//
// Both answers are the compiler's own: it preprocesses a copy of the sources that tells them, in C and as C++.
#pragma once

#include "program/build/compile.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace symreal::program {

struct CSources {
  std::set<std::string> sources; // real paths
  // What the compiler must be told besides, by the real path of the source.
  std::map<std::string, std::vector<std::string>> flags;
};

// Renames in the rewritten files. `sources` are all of the program's; throws c_source where an answer of C cannot be
// given.
CSources as_in_c(rewrite::Result &rewritten, std::vector<rewrite::Compilation> const &sources,
                 std::vector<std::string> const &compiler, std::vector<std::string> const &c_compiler,
                 std::string const &type_name, Workspace const &workspace);

} // namespace symreal::program
