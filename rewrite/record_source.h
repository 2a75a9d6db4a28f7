// Reads one source with Clang.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/facts.h"

namespace symreal::rewrite {

struct Scope;

// Facts::broken says that it does not compile. Throws DiagnosticError where it cannot be read. Several may be read at
// once, in threads.
Facts record_source(Compilation const &compilation, Scope const &scope, Request const &request);

// A file system of the source's own, since several may be read at once: the disk, the request's texts, and the
// directory in which the compiler runs. Throws where it or the source does not exist.
using FileSystem = llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem>;
FileSystem file_system(Compilation const &compilation, Request const &request);

// The words with which Clang is asked to read it.
std::vector<std::string> command_line(Compilation const &compilation);

} // namespace symreal::rewrite
