// Records a family of programs: one size after the other, through the stages of `generate` up to the optimised graph.
#pragma once

#include "program/record/front.h"
#include "tool/analysis/sweep_table.h"
#include "tool/report/console.h"

#include <functional>
#include <optional>

namespace symreal::tool {

struct SweepRequest {
  SweepSizes sizes;
  bool as_argument = false; // of the program, after the others; otherwise a macro of the sources
  // For these flags of the compiler besides.
  std::function<program::FrontRequest(std::vector<std::string> const &flags)> front;
  std::vector<rewrite::ConfiguredText> calls;
};

// Calls `take` with the recorded graph of each size. False when an error was reported. Throws sweep_differs.
bool record_sweep(SweepRequest const &request, Console &console, std::function<void(long size, Graph)> const &take);

} // namespace symreal::tool
