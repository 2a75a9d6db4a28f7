// Rewriting of declaration specifiers that C allows and C++ does not: `auto` beside a type, a missing type, which is
// int, and a structure defined in a function's return type.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_c_specifiers(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
