// Report on the run on a kernel: a table, or JSON.
#pragma once

#include "engine/graph/graph.h"
#include "program/record/explore.h"

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

// Operation counts of a recorded graph, before the passes.
struct RecordedCounts {
  OperationCounts operations;           // distinct operations, live or not
  std::vector<std::size_t> by_location; // by location of the graph
};
RecordedCounts counts_of(Graph const &recorded);

struct KernelReport {
  RecordedCounts recorded;
  Graph const *graph;                                  // optimised; its interface and run data are as recorded
  std::vector<Stage> stages;                           // live operations after each pass
  std::vector<std::string> files;                      // files written
  std::vector<std::pair<std::string, double>> seconds; // times by part of the run
  program::Exploration const *exploration = nullptr;   // null unless the kernel was explored
  std::optional<OperationCounts> looped = {};          // operations of compute inside and outside the loops of --reroll
};

// Prints the table; with `details`, every object and the effect of every pass.
void print_table(std::ostream &out, KernelReport const &report, bool details);

nlohmann::ordered_json to_json(KernelReport const &report);

} // namespace symreal::tool
