// Options and input of analyses: the costs of operations, the goal of the levelled schedule, and the graph, unchanged
// or after passes.
#pragma once

#include "engine/analysis/figures/figures.h"
#include "engine/graph/graph.h"
#include "tool/options/pass_options.h"

#include <CLI/CLI.hpp>
#include <string>

namespace symreal::tool {

struct AnalysisOptions {
  std::string cost = "unit";
  std::uint32_t units = 0;
  double length = 0;

  void add_to(CLI::App &app);
  Goal goal(Costs const &costs) const;
};

void add_passes_before_analysis(CLI::App &command, PassOptions &passes);

// Throws option_without_effect for a mode of passes without passes.
Graph analyzed_graph(CLI::App const &command, PassOptions const &passes, std::string const &file);

} // namespace symreal::tool
