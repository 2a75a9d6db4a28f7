// The program that calls kernels which no program calls: main, beside the sources that define them. It lies in no file.
#pragma once

#include "program/front.h"
#include "tool/report/console.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

// As program::run_front, of the kernels that these words call (call_spec.h); without any of those that the sources
// have. `lacking`: see program::Talk.
std::optional<program::Front> run_front(program::FrontRequest request,
                                        std::vector<rewrite::ConfiguredText> const &calls, Console &console,
                                        std::function<void(program::Recorded const &)> lacking = {});

} // namespace symreal::tool
