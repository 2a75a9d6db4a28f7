// Notes which arguments of macros become text (#parameter) or part of a pasted token (parameter ## ...).
//
// An argument in which another macro was expanded first is no text of the file: there the spelling comes from that
// macro's body, which has other uses, and may become REAL. What the outermost macro expands to is noted instead.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/expansion_text.h"
#include "rewrite/facts.h"
#include "rewrite/source_map.h"

#include <memory>

namespace symreal::rewrite {

std::unique_ptr<clang::PPCallbacks> make_quoted_argument_recorder(SourceMap const &map, Facts &facts,
                                                                  ExpansionText &expansions);

} // namespace symreal::rewrite
