// A use elsewhere (an argument, a loop's bound, another index) converts such an integer back to a plain one, which is a
// decision.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Calls `action` for each comparison of a loop's condition, where integers become plain: they are one number there, not
// one decision in each iteration.
void for_each_comparison(clang::Expr const *condition, llvm::function_ref<void(clang::BinaryOperator const *)> action);

// Finds symbolic integers in all functions of the roots and adds them to `reals`; changed spellings go to the facts.
void collect_symbolic_ints(clang::ASTContext &context, SourceMap const &map, Facts &facts, Reals &reals);

// Collects, in these declarations, the elements read at a symbolic index, and the uses that need a plain integer.
// `depends`: whether the expression is a symbolic integer. `keep`: spells it as one.
using IntegerTest = llvm::function_ref<bool(clang::Expr const *)>;
using IntegerAction = llvm::function_ref<void(clang::Expr const *)>;
void collect_integer_uses(clang::ASTContext &context, std::vector<clang::Decl *> const &declarations,
                          IntegerTest depends, IntegerAction keep, SourceMap const &map, Facts &facts, Reals &reals);

} // namespace symreal::rewrite
