// What C allows among the specifiers of a declaration, and C++ does not: `auto` beside a type, no type at all, which is
// an int, and a structure that is defined where a function says what it returns.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_c_specifiers(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
