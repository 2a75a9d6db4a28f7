#include "engine/analysis/costs/costs.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace symreal {

namespace {

Costs same_for_both(std::string name, std::string unit, OperationCosts const &costs) {
  Costs result{std::move(name), std::move(unit)};
  result.latency = costs;
  std::ranges::copy(costs, result.throughput.begin());
  result.is_known.fill(true);
  return result;
}

// Parts of a nanosecond in Time.
constexpr Time parts = 10;
constexpr double longest = 1e9; // nanoseconds: one second, far below the limit of Time

double nanoseconds(nlohmann::json const &entry, char const *which) {
  double const value = entry.at(which).get<double>();
  if (!(value >= 0 && value <= longest))
    throw std::out_of_range(fmt::format("'{}' is {}, which is not a time", which, value));
  return value;
}

void read_operations(nlohmann::json const &operations, Costs &costs) {
  for (auto const &[name, entry] : operations.items()) {
    auto const op = find_operation(name);
    if (!op) throw std::out_of_range("'" + name + "' is not an operation");
    auto const row = static_cast<std::size_t>(*op);
    costs.latency[row] = std::llround(nanoseconds(entry, "latency") * static_cast<double>(parts));
    costs.throughput[row] = nanoseconds(entry, "throughput");
    costs.is_known[row] = true;
  }
}

} // namespace

Costs unit_cost_model() { return same_for_both("unit", "operations", unit_costs()); }

Costs table_cost_model() { return same_for_both("table", "additions", table_costs()); }

Costs read_costs(std::string_view text, std::string const &file_name) {
  Costs costs{file_name, "ns", parts};
  try {
    nlohmann::json const json = nlohmann::json::parse(text);
    if (json.at("symreal-costs").get<int>() != 1) throw std::out_of_range("its version is not 1");
    read_operations(json.at("nanoseconds"), costs);
    if (json.contains("load")) costs.load = nanoseconds(json, "load");
    if (json.contains("threads")) costs.threads = thread_costs(json.at("threads"));
  } catch (std::exception const &problem) {
    fail(DiagnosticId::cost_file, {file_name}, fmt::format("this file has no costs of operations: {}", problem.what()));
  }
  return costs;
}

CostModel cost_model(Costs const &costs) {
  CostModel model;
  for (OperationInfo const &row : operations()) {
    auto const at = static_cast<std::size_t>(row.op);
    if (!costs.is_known[at])
      fail(DiagnosticId::cost_file, {costs.name},
           fmt::format("this file has no cost of the operation '{}', and passes may use any", row.name));
    model.work[at] = costs.throughput[at];
    model.latency[at] = costs.in_unit(costs.latency[at]);
  }
  model.load = costs.load.value_or(model[Op::add]);
  return model;
}

void require_costs(Costs const &costs, Graph const &graph) {
  std::vector<char> const live = live_nodes(graph);
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (Op const op = graph.nodes[id].op; live[id] && !is_leaf(op) && !costs.is_known[static_cast<std::size_t>(op)])
      fail(DiagnosticId::cost_file, {costs.name},
           fmt::format("kernel '{}' has the operation '{}', of which this file has no cost", graph.kernel,
                       info(op).name));
}

} // namespace symreal
