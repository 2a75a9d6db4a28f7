// Finds the decisions on REALs (if, ?:, loops) and records how each becomes a select, or why it cannot.
#pragma once

#include "rewrite/facts.h"
#include "rewrite/pragma_handler.h"
#include "rewrite/reals.h"
#include "rewrite/source_map.h"

namespace symreal::rewrite {

void record_decisions(clang::ASTContext &context, SourceMap const &map, Reals const &reals, PragmaIndex const &index,
                      Facts &facts);

} // namespace symreal::rewrite
