// Finds the functions of the roots that the program calls and that no source defines: what a compiled library would
// supply works on double. Only code that is compiled into the program counts; an inline function of a header that
// nobody calls may mention what it likes.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <vector>

namespace symreal::rewrite {

void collect_boundaries(clang::ASTContext &context, std::vector<clang::FunctionDecl const *> const &definitions,
                        SourceMap const &map, Reals const &reals, Facts &facts);

} // namespace symreal::rewrite
