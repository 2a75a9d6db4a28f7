// Walk of one source's syntax tree that collects facts about the roots.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_tree(clang::ASTContext &context, SourceMap const &map, PragmaIndex const &index, Request const &request,
                  Facts &facts);

} // namespace symreal::rewrite
