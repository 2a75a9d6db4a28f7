// Macros of C sources, which symbolic mode compiles as C++: conditionals and macros must keep their meaning in C, but
// `#ifdef __cplusplus` is false in C, also in the program's headers, while the system headers are those of C++. So each
// name that a directive asks about and that C++ answers differently is renamed in the program's files, to
// `symreal_c_NAME`, and defined as in C.
//
// Both answers come from the compiler, which preprocesses an instrumented copy of the sources, in C and as C++.
#pragma once

#include "program/build/compile.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace symreal::program {

struct CSources {
  std::set<std::string> sources; // real paths
  // Additional compiler flags, by the real path of the source.
  std::map<std::string, std::vector<std::string>> flags;
};

// Renames macros in the rewritten files. `sources`: all sources of the program. Throws c_source if a C answer cannot be
// reproduced.
CSources as_in_c(rewrite::Result &rewritten, std::vector<rewrite::Compilation> const &sources,
                 std::vector<std::string> const &compiler, std::vector<std::string> const &c_compiler,
                 std::string const &type_name, Workspace const &workspace);

} // namespace symreal::program
