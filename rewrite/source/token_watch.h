// Watches the tokens on their way to the parser: notes every `double` of the roots, so that none is left out unseen,
// and every name that the rewriter itself would write.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/expansion_text.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// `type_name`: that of the request.
void watch_tokens(clang::Preprocessor &preprocessor, SourceMap const &map, std::string const &type_name, Facts &facts,
                  ExpansionText &expansions);

// Names of C sources that are keywords of C++: `new`, `class`, a `bool` of one's own. Symbolic mode compiles C as C++,
// so each gets another name there.
bool is_keyword_of_cpp(llvm::StringRef name);

// Whether a token of this name can be renamed. Names that a system header declares for C cannot.
bool is_renamed(llvm::StringRef name);

} // namespace symreal::rewrite
