// Layout of classes that depends on a number being a class: sizes and offsets are written down for the compiler to
// check, and members are kept out of a base class's padding.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_layouts(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

} // namespace symreal::rewrite
