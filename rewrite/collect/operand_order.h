// Operands with side effects on each other. The language leaves their order open; compilers have one order for built-in
// operators and another for those of a class, and read an argument that is a number at another time than one that is a
// class. The rewriter spells out gcc's order for the original where it matters.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_operand_order(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

} // namespace symreal::rewrite
