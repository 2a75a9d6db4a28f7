// Attachment of function pragmas to the definitions that follow them: their items are looked up by name there.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/pragma/pragma_handler.h"

#include <vector>

namespace symreal::rewrite {

// Gives each function pragma of this source the definition that follows it, and collects its return statements.
void attach_function_pragmas(std::vector<clang::FunctionDecl const *> const &definitions, SourceMap const &map,
                             Reals const &reals, ScalarState const &scalars, PragmaIndex const &index, Facts &facts);

// Attaches one function pragma to its definition; `names` are those that its items look up.
void attach_pragma(Span const &span, clang::FunctionDecl const *definition, std::vector<PragmaIndex::Name> const &names,
                   SourceMap const &map, Reals const &reals, ScalarState const &scalars, Facts &facts);

// The opening brace behind which a kernel's annotations go; the whole of a function-try-block, whose handlers belong to
// the kernel. None if a macro makes it.
std::optional<Span> entry_of(clang::FunctionDecl const *function, SourceMap const &map);

// The compound statement of a function's body or function-try-block; null without a body.
clang::Stmt const *block_of(clang::FunctionDecl const *function);

} // namespace symreal::rewrite
