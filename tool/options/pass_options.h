// Options for what is done to a graph: passes and their mode, derivatives, and the costs of operations.
#pragma once

#include "engine/analysis/costs/costs.h"
#include "engine/ops/floating_point.h"
#include "engine/optimise/passes/pass.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

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

// Derivatives as additional outputs of a kernel, requested by the program or by --differentiate.
struct DifferentiateOption {
  std::vector<std::string> requests;
  bool separate = false; // derivatives form a separate function

  bool is_given() const { return !requests.empty(); }
  void add_to(CLI::App &app);
  void add_separate_to(CLI::App &app);
  // The graph with its derivatives; unchanged if none are requested. Throws what differentiate throws.
  Graph applied(Graph graph, Report const &report) const;
};

// `cost`: unit, table, or a file of `symreal measure-costs`. Throws cost_file, unreadable_file.
Costs costs_named(std::string const &cost);
void add_cost_option(CLI::App &app, std::string &cost);

} // namespace symreal::tool
