// Options of analyses: the costs of operations, and the goal of the levelled schedule.
#pragma once

#include "engine/analysis/figures/figures.h"
#include "tool/options/cost_option.h"

#include <CLI/CLI.hpp>

#include <string>

namespace symreal::tool {

void add_cost_option(CLI::App &app, std::string &cost);

struct AnalysisOptions {
  std::string cost = "unit";
  std::uint32_t units = 0;
  double length = 0;

  void add_to(CLI::App &app);
  // Throws cost_file, unreadable_file.
  Costs costs() const;
  Goal goal(Costs const &costs) const;
};

} // namespace symreal::tool
