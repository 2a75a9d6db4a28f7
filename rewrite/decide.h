// From facts to what is done about them: the text of each file, the kernels, the diagnostics. Knows no Clang.
#pragma once

#include "rewrite/facts.h"

namespace symreal::rewrite {

Result decide(Facts facts);

// The kernels that the pragmas ask for, and what is wrong with them (kernels.cpp).
void collect_kernels(Facts const &facts, Result &result);

} // namespace symreal::rewrite
