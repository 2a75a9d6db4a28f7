// Optimiser of every run: recorded graph ──passes──▶ optimised graph, with the effect of each pass.
#pragma once

#include "engine/plan/reroll/reroll.h"
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

} // namespace symreal::tool
