// The program that calls kernels which no program calls: main, beside the sources that define them. It lies in no file.
#pragma once

#include "program/record/front.h"
#include "tool/report/console.h"

#include <functional>
#include <string>
#include <vector>

namespace symreal::tool {

// What is done with a request, and how it talks.
using Stages = std::function<void(program::FrontRequest const &request, program::Talk const &talk)>;

// Runs the stages on the kernels that these words call (call_spec.h), without any of those that the sources have; where
// there are no words, on the request as it is.
void with_driver(program::FrontRequest request, std::vector<rewrite::ConfiguredText> const &calls, program::Talk talk,
                 Console &console, Stages const &stages);

} // namespace symreal::tool
