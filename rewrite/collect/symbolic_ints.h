// Integers that keep their dependency in the symbolic program: conversions of REALs, local variables that hold them,
// and the elements of tables that are read at such an index.
//
//   int i = (int)(x / h);          REAL_INT(int) i = (REAL_INT(int))(x / h);
//   y = tab[i] + (x / h - i) ...   y = REAL_TABLE(tab)[i] + (x / h - i) ...
//
// Where such an integer goes elsewhere (an argument, a loop's bound, another index) it converts back to a plain one,
// which is a decision.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// The comparisons that a loop's condition consists of: there an integer is one number, not one decision each time
// round.
void for_each_comparison(clang::Expr const *condition, llvm::function_ref<void(clang::BinaryOperator const *)> action);

// Finds them in all functions of the roots and tells `reals`; what is spelled anew goes to the facts.
void collect_symbolic_ints(clang::ASTContext &context, SourceMap const &map, Facts &facts, Reals &reals);

// Of these declarations: the elements that are read at such an index, and where it must be a plain integer again.
// `depends` and `keep`: is the expression such an integer, and spell it so.
using IntegerTest = llvm::function_ref<bool(clang::Expr const *)>;
using IntegerAction = llvm::function_ref<void(clang::Expr const *)>;
void collect_integer_uses(clang::ASTContext &context, std::vector<clang::Decl *> const &declarations,
                          IntegerTest depends, IntegerAction keep, SourceMap const &map, Facts &facts, Reals &reals);

} // namespace symreal::rewrite
