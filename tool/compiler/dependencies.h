// Dependency file of an object, for make.
#pragma once

#include "tool/compiler/command_line.h"

namespace symreal::compiler {

// Fills in missing options: file and target are named after the output, as by gcc. Targets are escaped.
DependencyOptions completed(CommandLine const &line, std::string const &source);

// Text of the file. `options`: completed; the source comes first among the names.
std::string write_dependencies(DependencyOptions const &options, Words const &names);

} // namespace symreal::compiler
