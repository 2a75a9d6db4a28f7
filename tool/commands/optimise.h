// Optimiser of every run: recorded graph ──passes──▶ optimised graph, with the effect of each pass.
#pragma once

#include "engine/plan/plan.h"
#include "tool/options/code_options.h"
#include "tool/options/pass_options.h"
#include "tool/report/report.h"

#include <optional>
#include <vector>

namespace symreal::tool {

struct Optimised {
  Graph graph;
  std::vector<Stage> stages;
  RecordedCounts recorded;
  std::optional<Rerolled> loops = {}; // loops of the graph, before passes on their bodies
};
// Runs the passes, and with --snap first replaces constants by nearby exact ones: throws snap_changes_output if samples
// show that an output changes by more than the tolerance. Remarks go to `report`, or else standard error. Without
// `searches`, structure recovery stops after its first step.
Optimised optimise(Graph recorded, PassOptions const &options, Report const &report = {}, bool searches = true);

// Optimises for --reroll: in mode fast, structure recovery skips its search if the emitted graph then has loops.
Optimised optimise_around_loops(Graph recorded, PassOptions const &options, EmitterOptions const &emitter,
                                std::vector<Language const *> const &languages, Report const &report = {});

// Options for the form of the code.
struct CodeForm {
  PassOptions const &passes;
  EmitterOptions const &emitter;
  RerollOption const &reroll;
  VectorOption const &vector;
};

// The plan of a graph's code, and in words its sines and cosines at the start, its loops and its vectors.
struct PlannedCode {
  Plan plan = {};
  std::string angles = {}, loops = {}, lanes = {};
  std::optional<OperationCounts> looped = {}; // operations of compute inside and outside loops
  std::vector<Diagnostic> remarks = {};
};

// `found`: loops that were found before. The plan suits all of the languages.
PlannedCode planned_code(Schedule const &schedule, std::optional<Rerolled> const &found,
                         std::vector<Language const *> const &languages, CodeForm const &options);

} // namespace symreal::tool
