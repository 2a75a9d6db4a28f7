// Collection of macro arguments that become text (#parameter) or part of a pasted token (parameter ## ...).
//
// An argument in which another macro was expanded first takes its text from that macro's body, which has other uses,
// and may become REAL. The expansion of the outermost macro is noted instead.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/expansion_text.h"
#include "rewrite/source/source_map.h"

#include <memory>

namespace symreal::rewrite {

std::unique_ptr<clang::PPCallbacks> make_quoted_argument_collector(SourceMap const &map, Facts &facts,
                                                                   ExpansionText &expansions);

} // namespace symreal::rewrite
