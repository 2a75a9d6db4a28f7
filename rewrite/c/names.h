// Names of sources in C that clash in C++: with the C library's, more of whose headers symbolic mode includes, and a
// tag with a type's name.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_c_names(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
