// Classes whose layout a compiler may choose otherwise where a number is a class: their sizes and offsets are written
// down for it to check, and what it would put into the padding of a base class is kept out of it.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/facts.h"
#include "rewrite/reals.h"
#include "rewrite/source_map.h"

namespace symreal::rewrite {

void record_layouts(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

} // namespace symreal::rewrite
