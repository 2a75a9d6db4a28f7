#pragma once

#include "tool/compiler/command_line.h"

namespace symreal::compiler {

// Links with what a symbolic program needs; returns the exit status.
int link(Words const &compiler, Words words);

} // namespace symreal::compiler
