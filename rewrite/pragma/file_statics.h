// The variables of static storage duration that the files define, as the linker knows them.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Notes those of a file in the items of this source's pragmas that mean it, `scratch(file)`, and those that the program
// may change in the facts.
void note_statics(clang::ASTContext &context, SourceMap const &map, ScalarState const &scalars, Facts &facts);

} // namespace symreal::rewrite
