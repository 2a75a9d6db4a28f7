// Walks the syntax tree of one source and records the facts about what stands in the roots.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/facts.h"
#include "rewrite/pragma_handler.h"
#include "rewrite/source_map.h"

namespace symreal::rewrite {

void record_tree(clang::ASTContext &context, SourceMap const &map, PragmaIndex const &index, Request const &request,
                 Facts &facts);

} // namespace symreal::rewrite
