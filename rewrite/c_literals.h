// `(struct pair){1, x}` is an object in C, which lives as long as the block around it. In C++, as gcc has it, it is a
// value, whose address cannot be taken.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/facts.h"
#include "rewrite/source_map.h"

namespace symreal::rewrite {

void record_c_literals(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
