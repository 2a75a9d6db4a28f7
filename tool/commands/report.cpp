#include "tool/commands/optimise.h"
#include "tool/commands/subcommands.h"
#include "tool/html/page.h"
#include "tool/html/report_data.h"
#include "tool/output/outputs.h"

#include "engine/graph/graph_text.h"
#include "engine/support/files.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace symreal::tool {
namespace {

struct Options {
  std::string file, output, units = "4", cost = "unit", verification;
  PassOptions passes;
};

void run(Options const &options) {
  if (std::filesystem::path(options.output).extension() != ".html")
    fail(DiagnosticId::bad_option, {}, "-o takes a file that ends in .html, not '" + options.output + "'");
  Graph const recorded = read_graph(read_file(options.file), options.file);
  require_writable(options.output);
  Costs const costs = costs_named(options.cost);
  nlohmann::ordered_json verification;
  if (!options.verification.empty()) verification = read_verification(options.verification, recorded.kernel);
  Optimised const optimised = optimise(recorded, options.passes);
  Sources const sources(recorded);
  std::string const text =
      page(recorded.kernel, report_data({{optimised.recorded, &optimised.graph, optimised.stages, {}, {}},
                                         costs,
                                         options.passes.floating_point(),
                                         options.units,
                                         std::move(verification)},
                                        sources));
  for (Diagnostic const &warning : gone_sources(sources)) print(std::cerr, warning);
  write_outputs({{{options.output, text}}});
}

} // namespace

void add_report(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("report", "Write a page on a graph: operations, sources, plots, timetable");
  auto options = std::make_shared<Options>();
  command->add_option("graph", options->file, "Graph text, as written by generate --graph")->required();
  command->add_option("-o", options->output, "The page")->required()->type_name("FILE.html");
  command
      ->add_option("--units", options->units,
                   "Units of the timetable: number, or number per kind of operation: mul=2,arithmetic=1,other=1")
      ->capture_default_str()
      ->type_name("N|KIND=N,...");
  add_cost_option(*command, options->cost);
  command->add_option("--verification", options->verification, "Output of verify --json, to show on the page")
      ->type_name("FILE");
  options->passes.add_to(*command);
  command->callback([options, &session] {
    refuse_flags(session);
    run(*options);
  });
}

} // namespace symreal::tool
