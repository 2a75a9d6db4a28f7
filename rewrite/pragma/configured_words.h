// The words of a configured clause as the tokens of a directive, each at its place in the configuration.
#pragma once

#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

// function CLAUSE(items)
PragmaWords function_words(ConfiguredClause const &clause, clang::ASTContext &context);

// external(FUNCTION) [pure] CLAUSE(items) ...
PragmaWords external_words(ConfiguredExternal const &external, clang::ASTContext &context);

} // namespace symreal::rewrite
