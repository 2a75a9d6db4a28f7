// Data of a report, from a graph and its optimised form to JSON.
#pragma once

#include "engine/analysis/costs/costs.h"
#include "engine/ops/floating_point.h"
#include "tool/html/sources.h"
#include "tool/report/report.h"

#include <nlohmann/json.hpp>

namespace symreal::tool {

struct ReportRequest {
  KernelReport kernel;
  Costs costs;
  FloatingPoint mode;
  std::string units;                   // units of the timetable, as for `schedule --units`
  nlohmann::ordered_json verification; // this kernel's record from `verify --json`; null if not given
};

// Throws nothing_to_analyze, bad_option, no_unit.
nlohmann::ordered_json report_data(ReportRequest const &request, Sources const &sources);

// This kernel's record in a file that `verify --json` printed. Throws verification_file.
nlohmann::ordered_json read_verification(std::string const &file, std::string const &kernel);

} // namespace symreal::tool
