// --package: a kernel as a Python package, whose C is compiled where the package is installed.
#pragma once

#include "tool/output/outputs.h"

#include <string>
#include <vector>

namespace symreal::tool {

// The files of the package, in `folder`; pyproject.toml first. It is called as --prefix says, or as the kernel.
std::vector<OutputFile> package_files(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                                      std::string const &folder);

} // namespace symreal::tool
