// Undefined symbols of each symbol of a source, as its object file will have them. Dead code counts as well: the linker
// needs its definitions.
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
