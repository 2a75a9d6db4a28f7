// Watches the tokens on their way to the parser: notes every `double` of the roots, so that none is left out unseen,
// and refuses names that the rewriter itself writes.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/expansion_text.h"
#include "rewrite/facts.h"
#include "rewrite/source_map.h"

namespace symreal::rewrite {

void watch_tokens(clang::Preprocessor &preprocessor, SourceMap const &map, Facts &facts, ExpansionText &expansions);

} // namespace symreal::rewrite
