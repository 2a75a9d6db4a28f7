// Check of a C source's declarations that have another meaning in C++.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Reports, for a source in C, the uses of names that would be others in C++, and structures of another size.
void collect_c_declarations(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
