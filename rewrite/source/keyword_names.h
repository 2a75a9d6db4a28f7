// Names of C sources that are keywords of C++: `new`, `class`, a `bool` of one's own. Symbolic mode compiles C as C++,
// so each gets another name there.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

bool is_keyword_of_cpp(llvm::StringRef name);

// Whether a token of this name can be renamed. Names that a system header declares for C cannot.
bool is_renamed(llvm::StringRef name);

// Notes a token of a C source that must be renamed.
void note_keyword_name(clang::Token const &token, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
