// Which sources are rewritten, and which are the build's own questions to the compiler.
#pragma once

#include "rewrite/rewrite.h"
#include "tool/compiler/command_line.h"

namespace symreal::compiler {

// $SYMREAL_ROOTS, directories separated by colons, or the directory of the project that the source belongs to: the
// nearest above it that holds .symreal.yaml or is the top of a repository, else the highest that says how to build it
// (CMakeLists.txt, meson.build, configure, Makefile), else its own. Empty if the source lies outside $SYMREAL_ROOTS.
Words roots_of(std::string const &source);

// What the source's .symreal.yaml leaves as it is.
rewrite::Exclusion exclusion_of(std::string const &source);

// CMake, Meson and configure try what the compiler can do with small files of their own. The answers are to be those
// that the numeric build gets.
bool is_probe(std::string const &source);

} // namespace symreal::compiler
