// Which symbols of other sources each symbol of a source needs, as its object file will. What cannot run counts as
// well: the compiler has to be given it.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <vector>

namespace symreal::rewrite {

// `definitions`: of functions, within the roots.
void collect_links(clang::ASTContext &context, std::vector<clang::FunctionDecl const *> const &definitions,
                   SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
