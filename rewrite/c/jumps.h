// Rewriting of C jumps past initialisations.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Turns each initialisation in a C source that a `case`, a `default` or a `goto` jumps past into an assignment, since
// C++ forbids such jumps.
void collect_c_jumps(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
