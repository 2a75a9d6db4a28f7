// Options for the sources that a subcommand reads, their build, and the run of the program.
#pragma once

#include "program/build/cache_directory.h"
#include "program/build/tree_edit.h"
#include "program/record/front.h"
#include "rewrite/rewrite.h"
#include "tool/configuration/configuration.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace symreal::tool {

// Compiler flags after `--` on the command line.
using CompilerFlags = std::vector<std::string>;

struct ProjectOptions {
  rewrite::Request request;
  std::vector<rewrite::ConfiguredText> calls; // calls of kernels that no program calls (call_spec.h)
  std::string build;                          // directory of compile_commands.json
  std::string configuration;                  // configuration file; empty: the nearest .symreal.yaml
  bool no_cache = false;

  void add_to(CLI::App &app); // adds the sources and the build options
  void add_build_to(CLI::App &app);
  // Applies the configuration to options that the command line does not set. It may set every option of the subcommand,
  // so this comes first; `sources` are those of the command line.
  void configure(CLI::App &command, ConfiguredOptions &given);
  // The configuration file; empty if not found, or with `or_new` the path to create.
  std::string configuration_file(bool or_new = false) const;
  // The full request, including excluded sources, which a program still needs.
  rewrite::Request complete(CompilerFlags const &flags) const;
  // Paths where no .symreal.yaml was found.
  std::vector<std::string> absent_configurations() const;
  // Cache that persists across runs; may be disabled.
  std::shared_ptr<program::CacheDirectory> cache() const;

private:
  std::filesystem::path configuration_start() const;
};

// Sources, their build, and the run of the program.
struct SourceOptions {
  ProjectOptions project;
  std::string run_arguments, link;
  program::FrontRequest front;

  void add_to(CLI::App &app);
  program::FrontRequest request(CompilerFlags const &flags) const;
};

// The request without excluded sources.
rewrite::Request only_rewritten(rewrite::Request request);

// Recovers from a killed rewrite, before anything else touches the tree, and reports it on standard error.
program::Recovery recover(std::string const &directory);

} // namespace symreal::tool
