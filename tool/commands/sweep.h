// Recording of a family of programs: runs the stages of `generate` up to the optimised graph, one size after the other.
#pragma once

#include "program/record/front.h"
#include "tool/analysis/sweep_table.h"
#include "tool/report/console.h"

#include <functional>
#include <optional>

namespace symreal::tool {

struct SweepRequest {
  SweepSizes sizes;
  bool as_argument = false; // the size is the program's last argument; false: a macro of the sources
  // Front request with these additional compiler flags.
  std::function<program::FrontRequest(std::vector<std::string> const &flags)> front;
  std::vector<rewrite::ConfiguredText> calls;
};

// Calls `take` with the recorded graph of each size. False after an error was reported. Throws sweep_differs.
bool record_sweep(SweepRequest const &request, Console &console, std::function<void(long size, Graph)> const &take);

} // namespace symreal::tool
