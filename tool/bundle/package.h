// A kernel as a Python package whose C code is compiled at installation.
#pragma once

#include "tool/output/outputs.h"

#include <string>
#include <vector>

namespace symreal::tool {

// Files of the package in `folder`, pyproject.toml first. --prefix or else the kernel names it.
std::vector<OutputFile> package_files(Plan const &plan, EmitterOptions const &options, FloatingPoint mode,
                                      std::string const &folder);

} // namespace symreal::tool
