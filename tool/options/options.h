// Options that several subcommands share, and how they are told to CLI11.
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

// Sources, how they are built and how the program is run.
struct SourceOptions {
  ProjectOptions project;
  std::string run_arguments, link;
  program::FrontRequest front;

  void add_to(CLI::App &app);
  program::FrontRequest request(CompilerFlags const &flags) const;
};

// Which passes run, in which floating-point mode.
struct PassOptions {
  std::string mode = "finite", passes = "default", snap, target_cost = "table";
  int effort = algebra::usual_effort;
  double tolerance = 1e-9; // of --snap
  CLI::Option *passes_option = nullptr, *effort_option = nullptr, *tolerance_option = nullptr;

  void add_to(CLI::App &app);
  bool is_given() const { return passes_option && passes_option->count() != 0; } // which passes
  FloatingPoint floating_point() const;
  // Throws bad_option for what is out of range, option_without_effect for what is of another mode than fast, cost_file,
  // unreadable_file.
  PassSettings settings() const;
  // How near a constant is to the number that --snap takes it for; nothing without --snap.
  std::optional<double> snap_distance() const;
  std::vector<std::string> names() const;
};

// The form of the generated code.
struct EmitterOptions {
  std::string prefix, real = "double", sines; // sines: empty where it was not given
  std::set<std::string, std::less<>> extras;  // files on request (emit/language/language.h)
  bool trace_comments = false, check_values = false;
  Nesting nesting() const { return check_values ? Nesting::none : Nesting::bounded; }
  std::string map_file;
  std::string reference; // as in EmitOptions

  void add_to(CLI::App &app);
  // Throws bad_option for another word than these.
  bool is_single() const;
  // Whether sines and cosines of inputs are computed side by side: usual in mode fast. Throws bad_option where it was
  // asked for and cannot be.
  bool has_angles(FloatingPoint mode) const;
};

// Fails for options about source files, where `instead` writes others.
void require_no_source_options(CLI::App &command, std::string const &instead);

// Fails unless `value` is among the words, separated by '|'.
void require_one_of(std::string const &option, std::string const &value, std::string_view words);

} // namespace symreal::tool
