// The back half of every run: recorded graph ──passes──▶ optimised graph, with what each pass did.
#pragma once

#include "engine/plan/reroll/reroll.h"
#include "tool/commands/exact_constants.h"
#include "tool/options/language_option.h"
#include "tool/options/options.h"
#include "tool/report/report.h"

#include <optional>
#include <vector>

namespace symreal::tool {

struct Optimised {
  Graph graph;
  std::vector<Stage> stages;
  RecordedCounts recorded;
  std::optional<Rerolled> loops = {}; // of the graph, on whose bodies passes are yet to work
};
// Remarks go to standard error unless `report` takes them. Without `searches` structure recovery stops behind its first
// step.
Optimised optimise(Graph recorded, PassOptions const &options, Report const &report = {}, bool searches = true);

// For --reroll: in mode fast structure recovery does not search where that leaves loops in the graph as it is emitted.
Optimised optimise_around_loops(Graph recorded, PassOptions const &options, EmitterOptions const &emitter,
                                std::vector<Language const *> const &languages, Report const &report = {});

} // namespace symreal::tool
