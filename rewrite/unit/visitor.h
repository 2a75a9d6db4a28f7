// Walks the syntax tree of one source and collects the facts about what stands in the roots.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_tree(clang::ASTContext &context, SourceMap const &map, PragmaIndex const &index, Request const &request,
                  Facts &facts);

} // namespace symreal::rewrite
