// The back half of every run: recorded graph ──passes──▶ optimised graph, with what each pass did.
#pragma once

#include "tool/commands/exact_constants.h"
#include "tool/options/options.h"
#include "tool/report/report.h"

namespace symreal::tool {

struct Optimised {
  Graph graph;
  std::vector<Stage> stages;
  RecordedCounts recorded;
};
// Remarks go to standard error unless `report` takes them.
Optimised optimise(Graph recorded, PassOptions const &options, Report const &report = {});

} // namespace symreal::tool
