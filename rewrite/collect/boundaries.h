// Search for functions of the roots that the program calls and that no source defines: those of a compiled library work
// on double. Only code that is compiled into the program counts; an uncalled inline function of a header may mention
// any function.
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
