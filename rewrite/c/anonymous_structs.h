// Structures without a name within others.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Gives each anonymous structure that holds REALs a name, in its declaration and at the uses of its members: C++
// forbids members of class type in anonymous structures.
void collect_anonymous_structs(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

} // namespace symreal::rewrite
