// Arrays that C has and C++ does not: characters without room for the zero behind them, and parameters that say how
// long they are: `double a[n][n]`, `double a[static 3]`.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/facts.h"
#include "rewrite/source_map.h"

namespace symreal::rewrite {

void record_c_arrays(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
