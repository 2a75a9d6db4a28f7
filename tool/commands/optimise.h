// The back half of every run: recorded graph ──passes──▶ optimised graph, with what each pass did.
#pragma once

#include "schedule/schedule.h"
#include "tool/commands/exact_constants.h"
#include "tool/options/options.h"
#include "tool/report/report.h"

#include <functional>

namespace symreal::tool {

struct Optimised {
  Graph graph;
  std::vector<Stage> stages;
  RecordedCounts recorded;
  bool has_searched = true; // otherwise passes are yet to work on the bodies of its loops
};
// Remarks go to standard error unless `report` takes them. Without `searches` structure recovery stops behind its first
// step.
Optimised optimise(Graph recorded, PassOptions const &options, Report const &report = {}, bool searches = true);

// For --reroll: in mode fast structure recovery does not search where that leaves loops in the graph as `layout` lays
// it out.
Optimised optimise_around_loops(Graph recorded, PassOptions const &options, Report const &report,
                                std::function<Schedule(Graph const &)> const &layout);

} // namespace symreal::tool
