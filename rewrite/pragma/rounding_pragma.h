// `#pragma STDC FENV_ROUND FE_UPWARD`: arithmetic that does not round to nearest, by the text.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <memory>

namespace symreal::rewrite {

std::unique_ptr<clang::PPCallbacks> make_rounding_pragma_watch(SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
