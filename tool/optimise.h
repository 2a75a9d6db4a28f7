// The back half of every run: recorded graph ──passes──▶ optimised graph, with what each pass did.
#pragma once

#include "tool/options.h"
#include "tool/report.h"

namespace symreal::tool {

struct Optimised {
  Graph graph;
  std::vector<Stage> stages;
};
Optimised optimise(Graph const &recorded, PassOptions const &options);

} // namespace symreal::tool
