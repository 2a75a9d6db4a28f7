// Choice of the sources to rewrite, as opposed to the build's own compiler probes.
#pragma once

#include "rewrite/rewrite.h"
#include "tool/compiler/command_line.h"

namespace symreal::compiler {

// Roots of a source: $SYMREAL_ROOTS, directories separated by colons, or else the source's project: the nearest parent
// with .symreal.yaml or a repository's top, else the highest that describes a build (CMakeLists.txt, meson.build,
// configure, Makefile), else its own directory. Empty if the source lies outside $SYMREAL_ROOTS.
Words roots_of(std::string const &source);

// Exclusions of the source's .symreal.yaml.
rewrite::Exclusion exclusion_of(std::string const &source);

// Is the source a probe by which CMake, Meson or configure tests the compiler? The answers must be those of the numeric
// build.
bool is_probe(std::string const &source);

} // namespace symreal::compiler
