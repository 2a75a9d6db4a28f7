// Generic selections of C11.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// For a source in C: the punctuation of _Generic becomes what a macro of the same name can take apart
// (<symreal/of_c.h>).
void collect_c_generic(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
