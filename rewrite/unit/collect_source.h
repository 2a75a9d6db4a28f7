// Reads one source with Clang.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/lookups.h"

namespace symreal::rewrite {

struct Scope;

// A file system that other threads do not change: each has a working directory of its own.
FileSystem own_disk();

// What the source's compiler sees: the disk, the request's texts, and the directory in which it runs. Throws where that
// or the source does not exist.
FileSystem file_system(Compilation const &compilation, Request const &request, FileSystem const &disk);

// Facts::broken says that it does not compile. Throws DiagnosticError where it cannot be read. Several may be read at
// once, in threads, each with a disk of its own.
Facts collect_source(Compilation const &compilation, Scope const &scope, Request const &request,
                     FileSystem const &disk);

// The words with which Clang is asked to read it.
std::vector<std::string> command_line(Compilation const &compilation);

} // namespace symreal::rewrite
