// Notes which arguments of macros become text (#parameter) or part of a pasted token (parameter ## ...).
#pragma once

#include "rewrite/clang.h"
#include "rewrite/facts.h"
#include "rewrite/source_map.h"

#include <memory>

namespace symreal::rewrite {

std::unique_ptr<clang::PPCallbacks> make_quoted_argument_recorder(SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
