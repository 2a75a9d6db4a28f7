// Reads one source with Clang.
#pragma once

#include "rewrite/facts.h"

namespace symreal::rewrite {

// Facts::broken says that it does not compile. Throws DiagnosticError where it cannot be read. Several may be read at
// once, in threads.
Facts record_source(Compilation const &compilation, std::vector<std::string> const &roots);

} // namespace symreal::rewrite
