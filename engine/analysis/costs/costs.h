// Costs of operations: counted, by the cost table, or measured on a machine.
#pragma once

#include "engine/analysis/costs/thread_costs.h"
#include "engine/analysis/tasks/task_graph.h"
#include "engine/ops/operation.h"

#include <array>
#include <string>
#include <string_view>

namespace symreal {

// Latency is the time from operands to result; throughput is the cost of one of many independent operations. Both in
// `time_unit`; latency in `scale` parts of it, as in tasks.
struct Costs {
  std::string name;      // as in the option
  std::string time_unit; // "operations", "additions", "ns"
  Time scale = 1;
  OperationCosts latency = {};
  std::array<double, std::tuple_size_v<OperationCosts>> throughput = {};
  std::array<bool, std::tuple_size_v<OperationCosts>> is_known = {};
  std::optional<ThreadCosts> threads = {}; // from the file, if present
  std::optional<double> load = {};         // cost of a load, if the file states it

  double in_unit(Time time) const { return static_cast<double>(time) / static_cast<double>(scale); }
};

Costs unit_cost_model();
Costs table_cost_model();
// Parses a file written by `symreal measure-costs`. Throws cost_file.
Costs read_costs(std::string_view text, std::string const &file_name);

// Cost model of the passes. An unknown load costs as much as an addition. Throws cost_file if any operation is unknown,
// since passes may use all.
CostModel cost_model(Costs const &costs);

// Throws cost_file if the graph has a live operation of unknown cost.
void require_costs(Costs const &costs, Graph const &graph);

} // namespace symreal
