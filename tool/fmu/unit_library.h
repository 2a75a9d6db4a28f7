// The C of a functional mock-up unit, compiled for this machine.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace symreal::tool {

inline constexpr char const *unit_compiler_options =
    "-std=c99 -O2 -fno-fast-math -ffp-contract=off -fno-tree-slp-vectorize -fno-builtin-pow -fPIC -fvisibility=hidden";

// "x86_64-linux", as FMI 3.0 calls this machine.
std::string unit_platform();

// The bytes of a shared library of these files, names first, compiled by cc; those that end in .h are included.
std::string unit_library(std::vector<std::pair<std::string, std::string>> const &files);

} // namespace symreal::tool
