// Which sources a subcommand reads, and how they are compiled.
#pragma once

#include "program/build/cache_directory.h"
#include "rewrite/rewrite.h"
#include "tool/configuration/configuration.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace symreal::tool {

// What stands after `--` on the command line.
using CompilerFlags = std::vector<std::string>;

struct ProjectOptions {
  rewrite::Request request;
  std::vector<rewrite::ConfiguredText> calls; // of kernels that no program calls (call_spec.h)
  std::string build;                          // the directory of compile_commands.json
  std::string configuration;                  // its file; empty: the nearest .symreal.yaml
  bool no_cache = false;

  void add_to(CLI::App &app); // the sources and all of these:
  void add_build_to(CLI::App &app);
  // What the configuration says, where the command line does not. It may set every option of the subcommand, so this is
  // done first; `sources` are those of the command line.
  void configure(CLI::App &command, ConfiguredOptions &given);
  // Empty where there is none, or where it would be written.
  std::string configuration_file(bool or_new = false) const;
  // With the sources that are excluded, which a program needs all the same.
  rewrite::Request complete(CompilerFlags const &flags) const;
  // Where a .symreal.yaml was looked for in vain.
  std::vector<std::string> absent_configurations() const;
  // Where things are kept from run to run; perhaps nowhere.
  std::shared_ptr<program::CacheDirectory> cache() const;

private:
  std::filesystem::path configuration_start() const;
};

// Without the sources that are excluded.
rewrite::Request only_rewritten(rewrite::Request request);

} // namespace symreal::tool
