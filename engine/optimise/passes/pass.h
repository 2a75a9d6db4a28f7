// A pass is a function from graph to graph, one file and one row of passes.def. It is given the graph to keep: at ten
// million nodes a copy would be the most of what a run needs.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "engine/ops/cost_model.h"
#include "engine/ops/floating_point.h"
#include "engine/optimise/algebra/recovery.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

struct RewriteLimit;

// What a pass may do, how long it may search for more, and what is the cheaper of two ways. Of a mode alone it has the
// usual effort and costs.
struct PassSettings {
  PassSettings(FloatingPoint mode, int effort = algebra::usual_effort, CostModel const &costs = usual_costs())
      : mode(mode),
        effort(effort),
        costs(costs) {}

  FloatingPoint mode;
  int effort;           // of pass `recover`: algebra/recovery.h
  bool searches = true; // it does not stop behind its first step, after which what repeated still repeats
  CostModel costs;
  RewriteLimit *limit = nullptr; // of passes that rewrite node by node: sweep.h
  Report tell = {};              // of remarks for the user
};

#define PASS(name, ...) Graph pass_##name(Graph graph, PassSettings const &settings);
#include "engine/optimise/passes/passes.def"
#undef PASS

// One of passes.def.
struct PassInfo {
  std::string_view name;
  Graph (*run)(Graph, PassSettings const &);
  bool by_default;
  FloatingPoint mode; // the first in which it runs
  std::string_view doc;

  bool runs_in(FloatingPoint other) const { return mode <= other; }
};
std::span<PassInfo const> pass_table();
// Throws unknown_pass.
PassInfo const &find_pass(std::string_view name);

std::vector<std::string> default_passes();

// "a,b,c", where "default" stands for those that run by default; or "none". Throws unknown_pass.
std::vector<std::string> parse_passes(std::string_view text);

// Runs those of the passes that the mode allows, one after the other, and validates the graph after each. Throws
// unknown_pass.
Graph run_passes(Graph graph, std::span<std::string const> names, PassSettings const &settings);

} // namespace symreal
