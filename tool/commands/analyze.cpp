#include "tool/analysis/figures_report.h"
#include "tool/commands/analyzed_graph.h"
#include "tool/commands/optimise.h"
#include "tool/commands/subcommands.h"
#include "tool/commands/sweep.h"
#include "tool/options/option_table.h"
#include "tool/options/source_options.h"
#include "tool/output/outputs.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

struct Options {
  std::vector<std::string> files;
  AnalysisOptions analysis;
  PassOptions passes;
  SourceOptions source;
  std::vector<CLI::Option const *> of_sources;
  std::string sweep, csv, operations_csv;
  bool sweep_argument = false, json = false;
};

void require_sense(Options const &options) {
  if (!options.sweep.empty()) return;
  if (options.files.size() != 1) fail(DiagnosticId::bad_option, {}, "name one graph, or a family with --sweep");
  if (options.sweep_argument)
    fail(DiagnosticId::option_without_effect, {}, "--sweep-argument says how --sweep hands on a size");
  for (CLI::Option const *option : options.of_sources)
    if (option->count() != 0)
      fail(DiagnosticId::option_without_effect, {},
           option->get_name() + " says how sources are built and run, and '" + options.files.front() + "' is a graph");
}

void write_tables(std::vector<OutputFile> files) {
  std::erase_if(files, [](OutputFile const &file) { return file.path.empty(); });
  write_outputs({std::move(files)});
}

void analyze_graph(Options const &options, CLI::App const &command) {
  Costs const costs = costs_named(options.analysis.cost);
  Graph const graph = analyzed_graph(command, options.passes, options.files.front());
  Figures const all = figures(graph, costs, options.analysis.goal(costs));
  write_tables({{options.csv, options.csv.empty() ? "" : profile_csv(costs, all)},
                {options.operations_csv, options.operations_csv.empty() ? "" : operations_csv(graph, costs, all)}});
  if (options.json)
    std::cout << to_json(graph, costs, all).dump(2) << "\n";
  else
    print_figures(std::cout, graph, costs, all);
}

int analyze_family(Options &options, CLI::App &command, Session &session) {
  options.source.project.request.sources = options.files;
  options.source.project.configure(command, session.configured);
  (void)options.passes.settings();
  (void)options.passes.names();
  Costs const costs = costs_named(options.analysis.cost);
  SweepRequest request{parse_sweep(options.sweep), options.sweep_argument, {}, options.source.project.calls};
  request.front = [&](std::vector<std::string> const &flags) {
    CompilerFlags all = session.flags;
    all.insert(all.end(), flags.begin(), flags.end());
    program::FrontRequest front = options.source.request(all);
    front.run.floating_point = options.passes.mode;
    return front;
  };
  std::vector<SweepMember> members;
  std::string kernel;
  Console console;
  bool const is_recorded = record_sweep(request, console, [&](long size, Graph const &recorded) {
    Graph const graph = optimise(recorded, options.passes, [&](auto const &one) { console.report(one); }).graph;
    kernel = graph.kernel;
    members.push_back(sweep_member(size, graph, costs, figures(graph, costs, options.analysis.goal(costs))));
  });
  if (!is_recorded) return error;
  console.clear();
  write_tables({{options.csv, sweep_csv(request.sizes, members)}});
  if (options.json)
    std::cout << to_json(kernel, request.sizes, costs, members).dump(2) << "\n";
  else
    print_sweep(std::cout, kernel, request.sizes, costs, members);
  return clean;
}

int run(Options &options, CLI::App &command, Session &session) {
  require_compatible(command);
  require_sense(options);
  if (!options.sweep.empty()) return analyze_family(options, command, session);
  refuse_flags(session);
  analyze_graph(options, command);
  return clean;
}

} // namespace

void add_analyze(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("analyze", "Show a graph's parallelism: levels, critical path, work and span");
  auto options = std::make_shared<Options>();
  command->add_option("files", options->files, "Graph text, as written by generate --graph; with --sweep: sources")
      ->required();
  options->analysis.add_to(*command);
  add_passes_before_analysis(*command, options->passes);
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->add_option("--csv", options->csv, "Also write the plots' numbers; with --sweep the table")
      ->type_name("FILE");
  command->add_option("--operations", options->operations_csv, "Also write the levels and the slack of every operation")
      ->type_name("FILE");
  command
      ->add_option("--sweep", options->sweep,
                   "Record a family of programs, with -DNAME=VALUE for each size, and fit how the figures grow")
      ->type_name("NAME=FIRST..LAST[:STEP]");
  command->add_flag("--sweep-argument", options->sweep_argument,
                    "Pass the size to the program as its last argument, not to the compiler");
  std::size_t const others = command->get_options().size();
  options->source.add_to(*command);
  std::vector<CLI::Option *> const all = command->get_options();
  options->of_sources.assign(all.begin() + static_cast<std::ptrdiff_t>(others), all.end());
  command->callback([options, command, &session] { session.status = run(*options, *command, session); });
}

} // namespace symreal::tool
