// --fmu: writes a kernel as a functional mock-up unit of FMI 3.0, for model exchange and co-simulation.
#pragma once

#include "tool/output/outputs.h"

#include <CLI/CLI.hpp>

#include <string>

namespace symreal::tool {

struct UnitOption {
  std::string file;

  void add_to(CLI::App &app);
  bool is_given() const { return !file.empty(); }
  // Fails for a file without the extension of units, and for options about files that are not written.
  void require_sense(CLI::App &command) const;
  // The unit's file; with several kernels the option names a directory. Throws bad_option for a kernel without states.
  OutputFile unit(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode, bool several) const;
};

} // namespace symreal::tool
