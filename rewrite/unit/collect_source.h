// Reading of one source with Clang.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/lookups.h"

namespace symreal::rewrite {

struct Scope;

// The disk for one thread: each has a working directory of its own.
FileSystem own_disk();

// File system of the source's compiler: the disk, the request's texts, and the directory in which it runs. Throws if
// that or the source does not exist.
FileSystem file_system(Compilation const &compilation, Request const &request, FileSystem const &disk);

// Collects the facts of a source; Facts::broken if it does not compile. Throws DiagnosticError if it cannot be read.
// Several threads may read at once, each with a disk of its own.
Facts collect_source(Compilation const &compilation, Scope const &scope, Request const &request,
                     FileSystem const &disk);

// Command line with which Clang reads the source.
std::vector<std::string> command_line(Compilation const &compilation);

} // namespace symreal::rewrite
