// Options for a recording: treatment of decisions on symbolic values, and of state that a kernel reads although it is
// neither input nor parameter.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "program/record/explore.h"
#include "program/record/record.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace symreal::tool {

// --decisions, --explore, --paths-met.
struct DecisionsOption {
  std::string policy = "error";
  std::vector<std::string> limits; // NAME=VALUE
  std::string paths_met;           // table of samples
  CLI::Option const *explore = nullptr, *met = nullptr;

  bool is_exploring() const { return policy == "explore" || policy == "auto"; }
  void add_to(CLI::App &app);
  // Throws bad_option, option_without_effect.
  void require_sense() const;
  // Policy with its bounds, as a recording takes it. Throws bad_option, unreadable_file.
  std::string of_recording() const;
};

// Hash of the table, stored in code generated with --paths-met. Throws unreadable_file.
std::string met_hash(std::string const &file);

// --frozen.
struct FrozenOption {
  std::string policy = "state";

  void add_to(CLI::App &app);
  void require_sense() const;
  // Reports the state that the kernels read; false if the policy makes it an error.
  bool accepts(std::vector<program::Recorded> const &kernels, Report const &report) const;
};

} // namespace symreal::tool
