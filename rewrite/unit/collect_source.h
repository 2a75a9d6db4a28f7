// Reading of one source with Clang.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/lookups.h"

#include <functional>

namespace symreal::rewrite {

struct PragmaIndex;
struct Scope;
class SourceMap;

// The disk for one thread: each has a working directory of its own.
FileSystem own_disk();

// File system of the source's compiler: the disk, the request's texts, and the directory in which it runs. Throws if
// that or the source does not exist.
FileSystem file_system(Compilation const &compilation, Request const &request, FileSystem const &disk);

// Collects the facts of a source; Facts::broken if it does not compile. Throws DiagnosticError if it cannot be read.
// Several threads may read at once, each with a disk of its own.
Facts collect_source(Compilation const &compilation, Scope const &scope, Request const &request,
                     FileSystem const &disk);

// Facts about the roots from a walk of the source's syntax tree (visitor.cpp).
void collect_tree(clang::ASTContext &context, SourceMap const &map, PragmaIndex const &index, Request const &request,
                  Facts &facts);

// Reads a source as far as it compiles, and visits its syntax tree. Its errors are ignored: the rewriter reports them.
void visit_tree(Compilation const &compilation, FileSystem const &files, Scope const &scope,
                std::function<void(clang::ASTContext &, SourceMap const &)> const &visit);

} // namespace symreal::rewrite
