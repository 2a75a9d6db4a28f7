// Critical path by source line: consecutive operations of one line form one entry.
#pragma once

#include "engine/analysis/figures/figures.h"
#include "engine/graph/operation_counts.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct PathLine {
  Place place;      // empty file: the graph has no places
  std::string name; // source name of the last of its values; may be empty
  Time start = 0, duration = 0;
  OperationCounts operations;
  std::size_t count = 0;
};
std::vector<PathLine> path_lines(Graph const &graph, std::vector<PathStep> const &path);

// Text such as "2 mul, add".
std::string to_string(OperationCounts const &operations);

// Source line without its indentation; empty if it cannot be read.
std::string source_text(Place const &place);

} // namespace symreal::tool
