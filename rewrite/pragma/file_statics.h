// `scratch(file)`: the variables of static storage duration that a file defines, as the linker knows them.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Notes them in the items of this source's pragmas that mean a file.
void note_file_statics(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
