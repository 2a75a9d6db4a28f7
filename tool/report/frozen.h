// State that a kernel read and that is neither input nor parameter: what becomes of it by --frozen.
#pragma once

#include "program/record/record.h"
#include "tool/report/console.h"

#include <CLI/CLI.hpp>

namespace symreal::tool {

// --frozen
struct FrozenOption {
  std::string policy = "state";

  void add_to(CLI::App &app);
  void require_sense() const;
};

// False when it is an error.
bool report_frozen(std::vector<program::Recorded> const &kernels, FrozenOption const &option, Console &console);

} // namespace symreal::tool
