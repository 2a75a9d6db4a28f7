// Resolution of pragma items: region items by the statements that the pragma handler put into the token stream, those
// of function pragmas by look-up of their names in the function that follows.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <vector>

namespace symreal::rewrite {

// Notes for a statement inserted for a pragma's item that the item was seen there, and its type.
void note_item(clang::Stmt const *statement, clang::ASTContext const &context, Reals const &reals,
               ScalarState const &scalars, PragmaIndex const &index, Facts &facts);

// Gives each function pragma of this source the definition that follows it, and collects its return statements.
void attach_function_pragmas(std::vector<clang::FunctionDecl const *> const &definitions, SourceMap const &map,
                             Reals const &reals, ScalarState const &scalars, PragmaIndex const &index, Facts &facts);

// Attaches one function pragma to its definition; `names` are those that its items look up.
void attach_pragma(Span const &span, clang::FunctionDecl const *definition, std::vector<PragmaIndex::Name> const &names,
                   SourceMap const &map, Reals const &reals, ScalarState const &scalars, Facts &facts);

// The compound statement of a function's body or function-try-block; null without a body.
clang::Stmt const *block_of(clang::FunctionDecl const *function);

} // namespace symreal::rewrite
