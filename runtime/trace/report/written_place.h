// Places as the rewriter writes them into a program.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <string_view>

namespace symreal::trace {

// "file:line:column"
Place written_place(std::string_view place);

} // namespace symreal::trace
