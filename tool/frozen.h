// State that a kernel read and that is neither input nor parameter: what becomes of it by --frozen.
#pragma once

#include "program/record.h"
#include "tool/console.h"

namespace symreal::tool {

// False when it is an error.
bool report_frozen(std::vector<program::Recorded> const &kernels, std::string const &policy, Console &console);

} // namespace symreal::tool
