// --package and --fmu: self-contained bundles of a kernel in place of source files.
#pragma once

#include "tool/output/outputs.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

struct Bundle {
  OutputFolder package; // empty path if not requested
  std::vector<OutputFile> units;

  void add_to(Outputs &outputs) const;
};

struct BundleOption {
  std::string package, unit; // folder of a Python package; file of a functional mock-up unit

  void add_to(CLI::App &app);
  bool is_given() const { return !package.empty() || !unit.empty(); }
  // Fails for a unit's file without the extension of units.
  void require_sense() const;
  // With several kernels, the options name directories. Throws bad_option for a kernel that calls functions of a
  // library, and for a unit without states.
  Bundle bundle(Plan const &plan, EmitterOptions const &options, FloatingPoint mode, bool several) const;
};

} // namespace symreal::tool
