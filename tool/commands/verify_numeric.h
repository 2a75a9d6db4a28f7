// verify --numeric: compares object code before and after rewriting.
#pragma once

#include "tool/commands/subcommands.h"
#include "tool/options/project_options.h"

namespace symreal::tool {

struct NumericOptions {
  bool enabled = false;
  std::string c_compiler;

  void add_to(CLI::App &app);
};

// `command`: verify, whose other options would have no effect. Returns the exit status.
int verify_numeric(CLI::App const &command, NumericOptions const &options, ProjectOptions const &project,
                   std::string const &cxx_compiler, bool keep, Session const &session);

} // namespace symreal::tool
