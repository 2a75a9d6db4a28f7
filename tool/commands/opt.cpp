#include "emit/emit.h"
#include "graph/graph_text.h"
#include "support/files.h"
#include "tool/commands/optimise.h"
#include "tool/commands/subcommands.h"
#include "tool/output/outputs.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace symreal::tool {
namespace {

struct Options {
  std::string file, output, language = "graph";
  PassOptions passes;
  EmitterOptions emitter;
  bool statistics = false, json = false;
};

void require_sense(Options const &options) {
  require_one_of("--lang", options.language, "graph|c");
  EmitterOptions const &emitter = options.emitter;
  if (options.language == "graph" && (emitter.mainline || !emitter.prefix.empty() || emitter.trace_comments ||
                                      emitter.check_values || !emitter.map_file.empty()))
    fail(DiagnosticId::option_without_effect, {},
         "--prefix, --mainline, --trace-comments, --map and --check-values shape generated code: use --lang=c");
  if (options.emitter.mainline && options.output.empty())
    fail(DiagnosticId::option_without_effect, {}, "--mainline writes a second file: name the first with -o");
  if (!emitter.map_file.empty() && options.output.empty())
    fail(DiagnosticId::option_without_effect, {}, "--map writes a second file: name the first with -o");
  if (options.json && options.output.empty())
    fail(DiagnosticId::option_without_effect, {}, "--json prints to standard output: name the result's file with -o");
}

std::vector<OutputFile> result_files(Graph const &graph, Options const &options) {
  if (options.language == "c")
    return emitted_files(graph, options.emitter, options.passes.floating_point(),
                         options.output.empty() ? graph.kernel + ".c" : options.output);
  std::ostringstream text;
  write_graph(text, graph);
  return {{options.output, text.str()}};
}

void run(Options const &options) {
  require_sense(options);
  Graph recorded = read_graph(read_file(options.file), options.file);
  Optimised optimised = optimise(recorded, options.passes);
  std::vector<OutputFile> files = result_files(optimised.graph, options);
  KernelReport report{&recorded, &optimised.graph, optimised.stages, {}, {}};
  if (options.output.empty()) {
    std::cout << files.front().text;
  } else {
    require_writable(files);
    report.files = write_files(files);
  }
  if (options.statistics) print_table(std::cerr, report, true);
  if (options.json) std::cout << to_json(report).dump(2) << "\n";
}

} // namespace

void add_opt(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("opt", "Run passes on the text of a graph; print the graph or emit code");
  auto options = std::make_shared<Options>();
  command->add_option("graph", options->file, "Graph text, as written by generate --graph")->required();
  command->add_option("-o", options->output, "Where the result goes (default: standard output)")->type_name("FILE");
  command->add_option("--lang", options->language, "graph or c")->capture_default_str();
  options->passes.add_to(*command);
  options->emitter.add_to(*command);
  command->add_flag("--stats", options->statistics, "Print the table of operations to standard error");
  command->add_flag("--json", options->json, "Print the table as JSON to standard output");
  command->callback([options, &session] {
    refuse_flags(session);
    run(*options);
  });
}

} // namespace symreal::tool
