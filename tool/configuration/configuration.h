// A project's configuration, .symreal.yaml: replaces pragmas and command-line options.
#pragma once

#include "rewrite/rewrite.h"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

namespace symreal::tool {

struct Configuration {
  struct Option {
    std::string name; // without dashes
    std::vector<std::string> values;
    Place place;
  };
  std::string directory; // directory of the file; relative names in it refer to it
  std::vector<std::string> roots;
  rewrite::Exclusion exclude;
  std::string type_name;
  std::vector<Option> options;
  std::vector<rewrite::ConfiguredKernel> kernels;
  std::vector<rewrite::ConfiguredText> calls; // kernels given as calls (call_spec.h)
  std::vector<rewrite::ConfiguredExternal> externals;
};

// The .symreal.yaml in the directory or its nearest parent; empty if not found.
std::string find_configuration(std::string const &directory);

// Reads a configuration. Throws configuration, with the place in the file.
Configuration read_configuration(std::string const &file);

// Place in the configuration, by option ("--decisions").
using ConfiguredOptions = std::map<std::string, Place>;

// Sets the options of the subcommand that the command line does not. An option that no subcommand has is an error.
void set_options(Configuration const &configuration, CLI::App &command, ConfiguredOptions &given);

// Moves a diagnostic about an option's value to the place in the configuration that sets it.
Diagnostic located(Diagnostic diagnostic, ConfiguredOptions const &given);

} // namespace symreal::tool
