// Operations by source line: shows where a kernel's work originates.
#pragma once

#include "tool/report/report.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <vector>

namespace symreal::tool {

struct LineCount {
  Place place; // column 0
  std::size_t recorded = 0, generated = 0;
};

// Counts by line, most generated operations first. Empty if the graph has no places.
std::vector<LineCount> operations_by_line(RecordedCounts const &recorded, Graph const &optimised);

void print_lines(std::ostream &out, std::vector<LineCount> const &lines);
nlohmann::ordered_json to_json(std::vector<LineCount> const &lines);

} // namespace symreal::tool
