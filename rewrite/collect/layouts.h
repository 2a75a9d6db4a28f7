// Classes whose layout a compiler may choose otherwise where a number is a class: their sizes and offsets are written
// down for it to check, and what it would put into the padding of a base class is kept out of it.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_layouts(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

} // namespace symreal::rewrite
