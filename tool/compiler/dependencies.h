// The file that tells make what an object was made from.
#pragma once

#include "tool/compiler/command_line.h"

namespace symreal::compiler {

// What the command line leaves open: file and target are named after the output as gcc does. The targets are escaped.
DependencyOptions completed(CommandLine const &line, std::string const &source);

// Its text. `options` is completed; the source comes first among the names.
std::string write_dependencies(DependencyOptions const &options, Words const &names);

} // namespace symreal::compiler
