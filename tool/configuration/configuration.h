// A project's configuration, .symreal.yaml: what else would stand in pragmas and on the command line.
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
  std::string directory; // of the file; relative names in it are below
  std::vector<std::string> roots;
  rewrite::Exclusion exclude;
  std::string type_name;
  std::vector<Option> options;
  std::vector<rewrite::ConfiguredKernel> kernels;
  std::vector<rewrite::ConfiguredText> calls; // kernels that are text: call_spec.h
  std::vector<rewrite::ConfiguredExternal> externals;
};

// The .symreal.yaml in the directory or the nearest above it, else nothing.
std::string find_configuration(std::string const &directory);

// Throws configuration, with the place in the file.
Configuration read_configuration(std::string const &file);

// By option, as in "--decisions": where the configuration says so.
using ConfiguredOptions = std::map<std::string, Place>;

// Sets those options of the subcommand that the command line does not. An option that no subcommand has is an error.
void set_options(Configuration const &configuration, CLI::App &command, ConfiguredOptions &given);

// A complaint about an option's value stands where the configuration gives it.
Diagnostic located(Diagnostic diagnostic, ConfiguredOptions const &given);

} // namespace symreal::tool
