// Compiler of a functional mock-up unit's C code for this machine.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace symreal::tool {

inline constexpr char const *unit_compiler_options =
    "-std=c99 -O2 -fno-fast-math -ffp-contract=off -fno-tree-slp-vectorize -fno-builtin-pow -fPIC -fvisibility=hidden";

// Name of this machine's platform in FMI 3.0, such as "x86_64-linux".
std::string unit_platform();

// Bytes of the shared library that cc compiles from these files (name, content); files that end in .h are included.
std::string unit_library(std::vector<std::pair<std::string, std::string>> const &files);

} // namespace symreal::tool
