// All that a report shows, from a graph and its optimised form to JSON.
#pragma once

#include "engine/analysis/figures/figures.h"
#include "engine/ops/floating_point.h"
#include "tool/html/sources.h"
#include "tool/report/report.h"

#include <nlohmann/json.hpp>

namespace symreal::tool {

struct ReportRequest {
  KernelReport kernel;
  Costs costs;
  FloatingPoint mode;
  std::string units;                   // of the timetable, as `schedule --units` takes them
  nlohmann::ordered_json verification; // of this kernel, as `verify --json` prints it; null: not given
};

// Throws nothing_to_analyze, bad_option, no_unit.
nlohmann::ordered_json report_data(ReportRequest const &request, Sources const &sources);

// The verification of this kernel in what `verify --json` printed to `file`. Throws verification_file.
nlohmann::ordered_json read_verification(std::string const &file, std::string const &kernel);

} // namespace symreal::tool
