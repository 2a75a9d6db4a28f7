// Copies of macro calls that turn an argument into text, as assert and the macros of test frameworks do.
//
// The text is data and stays: conversions in such an argument are made in a second copy of the call, for symbolic mode.
// Numeric mode sees the first copy, the original, only:
//
//   SYMREAL_REAL_EITHER((CHECK(x == half(1.0))), CHECK(x == half(REAL_C(1.0))))
#pragma once

#include "rewrite/edit/compose.h"
#include "rewrite/facts/facts.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::rewrite {

// Adds the wraps around calls that need a second copy, and removes their arguments from `quoted`. Copies from an
// earlier rewriting are quoted as a whole.
void copy_text_calls(Facts &facts, std::map<std::string, std::vector<Rewording>> &rewordings);

} // namespace symreal::rewrite
