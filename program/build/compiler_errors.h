// What a host compiler or linker printed, as a diagnostic on the user's source.
#pragma once

#include "program/build/overlay.h"
#include "program/build/process.h"

namespace symreal::program {

// `command` is what was run; its output and end say why it failed. `mode`: of the program that did not compile.
Diagnostic compiler_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay,
                            std::string const &mode = "in symbolic mode");
Diagnostic linker_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay);

} // namespace symreal::program
