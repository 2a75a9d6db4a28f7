// Passes: functions from graph to graph, each one file and one row of passes.def. A pass owns its argument, since a
// copy of ten million nodes would dominate the run time.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "engine/ops/floating_point.h"
#include "engine/ops/operation.h"
#include "engine/optimise/algebra/recovery.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

struct RewriteLimit;

// Settings of a pass: the floating-point mode, the search effort and the cost model, the last two with defaults.
struct PassSettings {
  PassSettings(FloatingPoint mode, int effort = algebra::usual_effort, CostModel const &costs = usual_costs())
      : mode(mode),
        effort(effort),
        costs(costs) {}

  FloatingPoint mode;
  int effort;           // of pass `recover`: algebra/recovery.h
  bool searches = true; // false: pass `recover` stops after its first step, which preserves repetition
  CostModel costs;
  RewriteLimit *limit = nullptr; // for passes that rewrite node by node: rule.h
  Report tell = {};              // for remarks to the user
};

#define PASS(name, ...) Graph pass_##name(Graph graph, PassSettings const &settings);
#include "engine/optimise/passes/passes.def"
#undef PASS

// A row of passes.def.
struct PassInfo {
  std::string_view name;
  Graph (*run)(Graph, PassSettings const &);
  bool by_default;
  FloatingPoint mode; // strictest mode in which it runs
  std::string_view doc;

  bool runs_in(FloatingPoint other) const { return mode <= other; }
};
std::span<PassInfo const> pass_table();
// Throws unknown_pass.
PassInfo const &find_pass(std::string_view name);

std::vector<std::string> default_passes();

// Parses "a,b,c", where "default" stands for the default passes, or "none". Throws unknown_pass.
std::vector<std::string> parse_passes(std::string_view text);

// Runs the passes that the mode allows, in order, and validates the graph after each. Throws unknown_pass.
Graph run_passes(Graph graph, std::span<std::string const> names, PassSettings const &settings);

} // namespace symreal
