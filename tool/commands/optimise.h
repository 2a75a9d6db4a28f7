// The back half of every run: recorded graph ──passes──▶ optimised graph, with what each pass did.
#pragma once

#include "tool/options/options.h"
#include "tool/report/report.h"

namespace symreal::tool {

struct Optimised {
  Graph graph;
  std::vector<Stage> stages;
};
Optimised optimise(Graph const &recorded, PassOptions const &options);

} // namespace symreal::tool
