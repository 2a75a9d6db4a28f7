// Operands that change what the other reads. The language leaves open which of them is evaluated first; compilers have
// one order for the operators of the language and another for those of a class, and read an argument that is a number
// at another time than one that is a class. What gcc does with the original is spelled out where it matters.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_operand_order(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

} // namespace symreal::rewrite
