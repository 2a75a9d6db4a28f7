// What a run on a kernel did, for the user: a table, or JSON.
#pragma once

#include "graph/graph.h"
#include "graph/operation_counts.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace symreal::tool {

struct Stage {
  std::string name; // "recorded", then the passes
  OperationCounts live;
};

struct KernelReport {
  Graph const *recorded;
  Graph const *optimised;
  std::vector<Stage> stages;                           // the operations that are live after each pass
  std::vector<std::string> files;                      // that were written
  std::vector<std::pair<std::string, double>> seconds; // by part of the run
};

// `details`: also every object and the effect of every pass.
void print_table(std::ostream &out, KernelReport const &report, bool details);

nlohmann::ordered_json to_json(KernelReport const &report);

} // namespace symreal::tool
