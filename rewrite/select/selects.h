// Finds the decisions on REALs (if, ?:, loops) and collects how each becomes a select, or why it cannot.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_decisions(clang::ASTContext &context, SourceMap const &map, Reals const &reals, PragmaIndex const &index,
                       Facts &facts);

} // namespace symreal::rewrite
