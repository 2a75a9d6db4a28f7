// Arrays that C has and C++ does not: characters without room for the zero behind them, and parameters that say how
// long they are: `double a[n][n]`, `double a[static 3]`.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_c_arrays(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
