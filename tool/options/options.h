// Options shared by several subcommands, and their registration with CLI11.
#pragma once

#include "engine/ops/floating_point.h"
#include "engine/optimise/passes/pass.h"
#include "engine/plan/schedule/schedule.h"
#include "program/record/front.h"
#include "tool/options/project_options.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace symreal::tool {

// Sources, their build, and the run of the program.
struct SourceOptions {
  ProjectOptions project;
  std::string run_arguments, link;
  program::FrontRequest front;

  void add_to(CLI::App &app);
  program::FrontRequest request(CompilerFlags const &flags) const;
};

// Passes to run, and the floating-point mode.
struct PassOptions {
  std::string mode = "finite", passes = "default", snap, target_cost = "table";
  int effort = algebra::usual_effort;
  double tolerance = 1e-9; // tolerance of --snap
  CLI::Option *passes_option = nullptr, *effort_option = nullptr, *tolerance_option = nullptr;

  void add_to(CLI::App &app);
  bool is_given() const { return passes_option && passes_option->count() != 0; } // is --passes given?
  FloatingPoint floating_point() const;
  // Throws bad_option for values out of range, option_without_effect for options of mode fast in other modes,
  // cost_file, unreadable_file.
  PassSettings settings() const;
  // Distance within which --snap replaces a constant; nullopt without --snap.
  std::optional<double> snap_distance() const;
  std::vector<std::string> names() const;
};

// Form of the generated code.
struct EmitterOptions {
  std::string prefix, real = "double", sines; // sines: empty if not given
  std::set<std::string, std::less<>> extras;  // optional files (emit/language/language.h)
  bool trace_comments = false, check_values = false;
  Nesting nesting() const { return check_values ? Nesting::none : Nesting::bounded; }
  std::string map_file;
  std::string reference; // as in EmitOptions

  void add_to(CLI::App &app);
  // Throws bad_option for an invalid word.
  bool is_single() const;
  // Are sines and cosines of inputs computed side by side? Default in mode fast. Throws bad_option if requested but
  // impossible.
  bool has_angles(FloatingPoint mode) const;
};

// Fails for options about source files if `instead` writes other files.
void require_no_source_options(CLI::App &command, std::string const &instead);

// Fails unless `value` is one of the words, separated by '|'.
void require_one_of(std::string const &option, std::string const &value, std::string_view words);

} // namespace symreal::tool
