// The critical path by source line: operations that follow each other and come from one line are one entry.
#pragma once

#include "engine/analysis/figures/figures.h"
#include "engine/graph/operation_counts.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct PathLine {
  Place place;      // an empty file: the graph has no places
  std::string name; // what the source calls the last of its numbers; may be empty
  Time start = 0, duration = 0;
  OperationCounts operations;
  std::size_t count = 0;
};
std::vector<PathLine> path_lines(Graph const &graph, std::vector<PathStep> const &path);

// "2 mul, add"
std::string to_string(OperationCounts const &operations);

// The line of the source without its indentation; empty where it cannot be read.
std::string source_text(Place const &place);

} // namespace symreal::tool
