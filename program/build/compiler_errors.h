// Diagnostics on the user's sources from the output of a host compiler or linker.
#pragma once

#include "program/build/overlay.h"
#include "program/build/process.h"

namespace symreal::program {

// `command`: the failed command, whose output and exit status explain the failure. `mode`: mode of the program.
Diagnostic compiler_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay,
                            std::string const &mode = "in symbolic mode");
Diagnostic linker_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay);

} // namespace symreal::program
