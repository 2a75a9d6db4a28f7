// Structures without a name within others.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// In symbolic mode a member of an anonymous structure may not be of a class; so one that holds REALs gets a name there,
// in its declaration and where its members are used.
void collect_anonymous_structs(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

} // namespace symreal::rewrite
