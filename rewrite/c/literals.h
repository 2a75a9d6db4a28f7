// Rewriting of compound literals: `(struct pair){1, x}` is an lvalue in C, which lives as long as the block around it.
// In C++, as gcc has it, it is an rvalue, whose address cannot be taken.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_c_literals(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
