// --frozen: treatment of state that a kernel read although it is neither input nor parameter.
#pragma once

#include "program/record/record.h"
#include "tool/report/console.h"

#include <CLI/CLI.hpp>

namespace symreal::tool {

// The option --frozen.
struct FrozenOption {
  std::string policy = "state";

  void add_to(CLI::App &app);
  void require_sense() const;
};

// Reports the state; false if the policy makes it an error.
bool report_frozen(std::vector<program::Recorded> const &kernels, FrozenOption const &option, Console &console);

} // namespace symreal::tool
