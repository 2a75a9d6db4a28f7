// What operations cost: counted, by the table, or as measured on a machine.
#pragma once

#include "engine/analysis/costs/thread_costs.h"
#include "engine/analysis/tasks/operation_tasks.h"
#include "engine/ops/cost_model.h"

#include <array>
#include <string>
#include <string_view>

namespace symreal {

// Latency: from operands to result. Throughput: what one costs of many that do not wait for each other. Both in
// `time_unit`, latency in `scale` parts of it as tasks have it.
struct Costs {
  std::string name;      // as the option spells it
  std::string time_unit; // "operations", "additions", "ns"
  Time scale = 1;
  OperationCosts latency = {};
  std::array<double, std::tuple_size_v<OperationCosts>> throughput = {};
  std::array<bool, std::tuple_size_v<OperationCosts>> is_known = {};
  std::optional<ThreadCosts> threads = {}; // of a file that has them
  std::optional<double> load = {};         // of a number in memory, of a file that says so

  double in_unit(Time time) const { return static_cast<double>(time) / static_cast<double>(scale); }
};

Costs unit_cost_model();
Costs table_cost_model();
// Of a file that `symreal measure-costs` wrote. Throws cost_file.
Costs read_costs(std::string_view text, std::string const &file_name);

// By which passes decide. A load that is not known costs as much as an addition. Throws cost_file where an operation is
// not known, since passes may use any.
CostModel cost_model(Costs const &costs);

// Throws cost_file where the graph has a live operation that the costs do not know.
void require_costs(Costs const &costs, Graph const &graph);

} // namespace symreal
