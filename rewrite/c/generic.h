// Generic selections of C11.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Rewrites the punctuation of _Generic in a C source into arguments for a macro of the same name (<symreal/of_c.h>).
void collect_c_generic(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
