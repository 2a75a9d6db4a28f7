// Reads one source with Clang.
#pragma once

#include "rewrite/facts.h"
#include "rewrite/lookups.h"

namespace symreal::rewrite {

struct Scope;

// Facts::broken says that it does not compile. Throws DiagnosticError where it cannot be read. Several may be read at
// once, in threads, each with a file system of its own.
Facts record_source(Compilation const &compilation, Scope const &scope, Request const &request, FileSystem const &disk);

// The words with which Clang is asked to read it.
std::vector<std::string> command_line(Compilation const &compilation);

} // namespace symreal::rewrite
