// What a jump passes in C.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// For a source in C: an initialisation that a `case`, a `default` or a `goto` passes becomes an assignment, since C++
// has no jump past one.
void collect_c_jumps(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
