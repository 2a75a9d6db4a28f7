#include "tool/analysis/plot.h"

#include "engine/support/files.h"
#include "program/build/process.h"
#include "program/build/workspace.h"
#include "tool/analysis/analysis_options.h"
#include "tool/commands/analyzed_graph.h"
#include "tool/commands/subcommands.h"
#include "tool/output/outputs.h"

#include <filesystem>
#include <fmt/format.h>
#include <memory>

namespace symreal::tool {
namespace {

struct Options {
  std::string file, output;
  AnalysisOptions analysis;
  PassOptions passes;
};

// Runs Gnuplot on the script, which writes `image`; returns the image.
std::string drawn(program::Workspace const &workspace, std::string const &script, std::string const &image) {
  std::string const file = workspace.file("plot.gp");
  write_if_changed(file, script);
  program::Captured const run = program::capture({{"gnuplot", file}});
  if (run.outcome.ending == program::Ending::not_started)
    fail(DiagnosticId::plotting_failed, {}, "'gnuplot' cannot be run");
  if (!run.outcome.success() || !std::filesystem::exists(image))
    fail(DiagnosticId::plotting_failed, {}, "'gnuplot' fails: " + run.output.substr(0, run.output.find('\n')));
  return read_file(image);
}

void run(Options const &options, CLI::App const &command) {
  Costs const costs = options.analysis.costs();
  program::Workspace const workspace(/*keep=*/false);
  std::string const image = workspace.file("plot" + std::filesystem::path(options.output).extension().string());
  Graph const graph = analyzed_graph(command, options.passes, options.file);
  require_writable(options.output);
  std::string const script = plot_script(graph, costs, figures(graph, costs, options.analysis.goal(costs)), image);
  write_outputs({{{options.output, drawn(workspace, script, image)}}});
}

} // namespace

void add_plot(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("plot", "Plot how many operations of a graph run in parallel");
  auto options = std::make_shared<Options>();
  command->add_option("graph", options->file, "Graph text, as written by generate --graph")->required();
  command->add_option("-o", options->output, "Image, .svg or .png")->required()->type_name("FILE");
  options->analysis.add_to(*command);
  add_passes_before_analysis(*command, options->passes);
  command->callback([options, command, &session] {
    refuse_flags(session);
    run(*options, *command);
  });
}

} // namespace symreal::tool
