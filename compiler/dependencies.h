// The file that tells make what an object was made from.
#pragma once

#include "compiler/command_line.h"

#include <functional>

namespace symreal::compiler {

// The names that a file written by the compiler lists, the source first.
Words read_dependencies(std::string const &text);

// The text as gcc writes it. `options` has a target.
std::string write_dependencies(DependencyOptions const &options, Words const &names);

// What the command line leaves open: file and target are named after the output as gcc does.
DependencyOptions completed(CommandLine const &line, std::string const &source);

} // namespace symreal::compiler
