// What a run on a kernel did, for the user: a table, or JSON.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/operation_counts.h"
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

// Of a recorded graph, before the passes take it.
struct RecordedCounts {
  OperationCounts operations;           // distinct ones, live or not
  std::vector<std::size_t> by_location; // of the graph
};
RecordedCounts counts_of(Graph const &recorded);

struct KernelReport {
  RecordedCounts recorded;
  Graph const *graph;             // optimised; what it says of its interface and of the run is as recorded
  std::vector<Stage> stages;      // the operations that are live after each pass
  std::vector<std::string> files; // that were written
  std::vector<std::pair<std::string, double>> seconds; // by part of the run
  program::Exploration const *exploration = nullptr;   // of a kernel that was explored
  std::optional<OperationCounts> looped = {};          // what compute does in the loops of --reroll and between them
};

// `details`: also every object and the effect of every pass.
void print_table(std::ostream &out, KernelReport const &report, bool details);

nlohmann::ordered_json to_json(KernelReport const &report);

} // namespace symreal::tool
