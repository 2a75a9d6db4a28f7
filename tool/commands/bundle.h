// --package and --fmu: self-contained bundles of a kernel in place of source files.
#pragma once

#include "tool/fmu/unit.h"
#include "tool/package/package_option.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct Bundle {
  OutputFolder package; // empty path if not requested
  std::vector<OutputFile> units;

  std::vector<OutputFile> files() const;
  void add_to(Outputs &outputs) const;
};

struct BundleOption {
  PackageOption package;
  UnitOption unit;

  void add_to(CLI::App &app);
  bool is_given() const { return package.is_given() || unit.is_given(); }
  void require_sense(CLI::App &command) const;
  Bundle bundle(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode, bool several) const;
};

} // namespace symreal::tool
