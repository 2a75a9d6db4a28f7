#include "tool/commands/analyzed_graph.h"

#include "engine/graph/graph_text.h"
#include "engine/support/files.h"
#include "tool/commands/optimise.h"

#include <cmath>

namespace symreal::tool {

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

Goal AnalysisOptions::goal(Costs const &costs) const {
  constexpr double longest = 1e15;
  double const parts = std::floor(length * static_cast<double>(costs.scale) + 1e-6);
  if (!(parts < longest)) fail(DiagnosticId::bad_option, {}, "--length is not a length of a schedule");
  return {units, length == 0 ? 0 : std::max<Time>(static_cast<Time>(parts), 1)};
}

void add_passes_before_analysis(CLI::App &command, PassOptions &passes) {
  passes.add_to(command);
  passes.passes_option->description(
      "Passes to run first (default: none on a graph, all on a family); symreal opt --help lists them");
}

Graph analyzed_graph(CLI::App const &command, PassOptions const &passes, std::string const &file) {
  for (char const *const option : {"--fp", "--effort", "--target-cost", "--snap", "--tol"})
    if (command.count(option) != 0 && !passes.is_given())
      fail(DiagnosticId::option_without_effect, {},
           std::string(option) + " is for passes: without --passes a graph is analyzed as it stands");
  Graph graph = read_graph(read_file(file), file);
  return passes.is_given() ? optimise(std::move(graph), passes).graph : graph;
}

} // namespace symreal::tool
