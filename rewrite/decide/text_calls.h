// Calls of macros that turn an argument into text, as assert and the macros of test frames do.
//
// The text is data and stays: what must be converted in such an argument is converted in a second copy of the call, for
// symbolic mode. In numeric mode the first copy, the original, is all there is:
//
//   SYMREAL_REAL_EITHER((CHECK(x == half(1.0))), CHECK(x == half(REAL_C(1.0))))
#pragma once

#include "rewrite/edit/compose.h"
#include "rewrite/facts/facts.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::rewrite {

// Adds the wraps around calls that need a second copy; what they hold is `quoted` no more. What a rewriting before has
// copied is quoted as a whole.
void copy_text_calls(Facts &facts, std::map<std::string, std::vector<Rewording>> &rewordings);

} // namespace symreal::rewrite
