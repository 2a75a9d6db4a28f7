#include "tool/analysis/analysis_options.h"

#include <cmath>

namespace symreal::tool {

void add_cost_option(CLI::App &app, std::string &cost) {
  app.add_option("--cost", cost,
                 "Cost of an operation: unit (1), table (the table of operations), or a file of symreal measure-costs")
      ->type_name("unit|table|FILE")
      ->capture_default_str();
}

void AnalysisOptions::add_to(CLI::App &app) {
  add_cost_option(app, cost);
  CLI::Option *const of_units =
      app.add_option("--units", units, "Level the operations for this number of parallel units")
          ->check(CLI::Range(1U, 1U << 20))
          ->type_name("P");
  app.add_option("--length", length, "Target length for levelling, in cost units (default: the span)")
      ->check(CLI::PositiveNumber)
      ->excludes(of_units);
}

Costs AnalysisOptions::costs() const { return costs_named(cost); }

Goal AnalysisOptions::goal(Costs const &costs) const {
  constexpr double longest = 1e15;
  double const parts = std::floor(length * static_cast<double>(costs.scale) + 1e-6);
  if (!(parts < longest)) fail(DiagnosticId::bad_option, {}, "--length is no length of a schedule");
  return {units, length == 0 ? 0 : std::max<Time>(static_cast<Time>(parts), 1)};
}

} // namespace symreal::tool
