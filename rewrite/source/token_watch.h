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

} // namespace symreal::rewrite
