// --package: folder of a Python package, in place of source files.
#pragma once

#include "tool/package/package.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

struct PackageOption {
  std::string folder;

  void add_to(CLI::App &app);
  bool is_given() const { return !folder.empty(); }
  // Fails for options about files that are not written beside a package.
  void require_sense(CLI::App &command) const;
  // The package's folder; with several kernels the option names a folder of packages.
  OutputFolder package(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode, bool several) const;
};

} // namespace symreal::tool
