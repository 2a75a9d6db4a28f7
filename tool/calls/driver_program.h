// Driver program: a main, in no file, that calls kernels which no program calls yet, beside their sources.
#pragma once

#include "program/record/front.h"
#include "tool/report/console.h"

#include <functional>
#include <vector>

namespace symreal::tool {

// Stages to run on a request.
using Stages = std::function<void(program::FrontRequest const &request, program::Talk const &talk)>;

// Runs the stages on the kernels that `calls` describe (call_spec.h), without the kernels of the sources; without
// calls, on the unchanged request.
void with_driver(program::FrontRequest request, std::vector<rewrite::ConfiguredText> const &calls, program::Talk talk,
                 Console &console, Stages const &stages);

} // namespace symreal::tool
