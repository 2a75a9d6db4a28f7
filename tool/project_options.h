// Which sources a subcommand reads, and how they are compiled.
#pragma once

#include "rewrite/rewrite.h"
#include "tool/options.h"

namespace symreal::tool {

struct ProjectOptions {
  rewrite::Request request;
  std::string build; // the directory of compile_commands.json

  void add_to(CLI::App &app);       // all of them
  void add_build_to(CLI::App &app); // -p and -j
  rewrite::Request complete(CompilerFlags const &flags) const;
};

} // namespace symreal::tool
