#include "tool/commands/analyzed_graph.h"

#include "engine/graph/graph_text.h"
#include "engine/support/files.h"
#include "tool/commands/optimise.h"

namespace symreal::tool {

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
