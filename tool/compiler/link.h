#pragma once

#include "tool/compiler/command_line.h"

namespace symreal::compiler {

// Links a symbolic program with its runtime; returns the exit status.
int link(Words const &compiler, Words words);

} // namespace symreal::compiler
