#include "engine/graph/graph_text.h"
#include "engine/plan/text/plan_text.h"
#include "engine/support/files.h"
#include "tool/analysis/parallel_option.h"
#include "tool/bundle/bundle.h"
#include "tool/commands/optimise.h"
#include "tool/commands/planned_code.h"
#include "tool/commands/subcommands.h"
#include "tool/options/code_options.h"
#include "tool/options/option_table.h"
#include "tool/options/pass_options.h"
#include "tool/output/outputs.h"
#include "tool/report/console.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace symreal::tool {
namespace {

struct Options {
  std::string file, output;
  LanguageOption language;
  BundleOption bundle;
  DifferentiateOption differentiate;
  PassOptions passes;
  EmitterOptions emitter;
  ParallelOption parallel;
  RerollOption reroll;
  VectorOption vector;
  bool statistics = false, json = false;
};

bool emits_code(Options const &options) { return options.bundle.is_given() || !options.language.languages().empty(); }

void require_sense(CLI::App const &command, Options const &options) {
  EmitterOptions const &emitter = options.emitter;
  if (!emits_code(options) && (!emitter.extras.empty() || !emitter.prefix.empty() || !emitter.debug.empty() ||
                               !emitter.map_file.empty() || emitter.is_single()))
    fail(DiagnosticId::option_without_effect, {},
         "--prefix, --real, --mainline, --mex, --simulink, --map and --debug shape generated "
         "code: use "
         "--lang=c");
  require_compatible(command);
  options.bundle.require_sense();
  bool const is_graph = options.language.text == "graph" && !options.bundle.is_given();
  if (options.vector.is_given() && is_graph)
    fail(DiagnosticId::option_without_effect, {}, "--vector makes vectors of operations: use --lang=c or --lang=plan");
  if (options.reroll.is_given && is_graph)
    fail(DiagnosticId::option_without_effect, {}, "--reroll makes loops of statements: use --lang=c or --lang=plan");
  if (options.parallel.is_given() && options.language.text == "graph")
    fail(DiagnosticId::option_without_effect, {},
         "--parallel shares out statements, which graphs do not have: use --lang=c");
  require_one_language(options.language.languages(), emitter);
  if (options.language.languages().size() > 1 && options.output.empty())
    fail(DiagnosticId::option_without_effect, {}, "several languages make several files: name the first with -o");
  if (!emitter.extras.empty() && options.output.empty())
    fail(DiagnosticId::option_without_effect, {},
         "--" + *emitter.extras.begin() + " writes a second file: name the first with -o");
  if (!emitter.map_file.empty() && options.output.empty())
    fail(DiagnosticId::option_without_effect, {}, "--map writes a second file: name the first with -o");
  if (options.json && options.output.empty() && !options.bundle.is_given())
    fail(DiagnosticId::option_without_effect, {}, "--json prints to standard output: name the result's file with -o");
}

// Input of the command: a graph, or a plan, which fixes the order of its operations.
struct Input {
  Graph graph;
  std::optional<ReadPlan> plan;
};

Input read_input(Options const &options) {
  std::string const text = read_file(options.file);
  if (!is_plan(text))
    return {options.differentiate.applied(read_graph(text, options.file),
                                          [](Diagnostic const &warning) { print(std::cerr, warning); }),
            {}};
  if (options.differentiate.is_given())
    fail(DiagnosticId::option_without_effect, {},
         "--differentiate works on graphs, and '" + options.file + "' is a plan");
  if (options.passes.is_given())
    fail(DiagnosticId::option_without_effect, {}, "passes work on graphs, and '" + options.file + "' is a plan");
  if (options.emitter.debugs("values"))
    fail(DiagnosticId::option_without_effect, {},
         "--debug=values lays a graph out in its own way, and '" + options.file + "' is a plan");
  if (options.parallel.is_given())
    fail(DiagnosticId::option_without_effect, {},
         "--parallel shares out a graph, and '" + options.file + "' is a plan, which says itself who computes what");
  for (bool const is_given : {options.reroll.is_given, options.vector.is_given()})
    if (is_given)
      fail(DiagnosticId::option_without_effect, {},
           "--reroll and --vector work on graphs, and '" + options.file + "' is a plan");
  return {{}, read_plan(text, options.file)};
}

Optimised optimised_graph(Graph graph, Options const &options) {
  Console console;
  console.stage("optimising");
  auto const report = [&](Diagnostic const &one) { console.report(one); };
  if (!options.reroll.is_given) return optimise(std::move(graph), options.passes, report);
  return optimise_around_loops(std::move(graph), options.passes, options.emitter, options.language.languages(), report);
}

std::vector<OutputFile> result_files(Optimised const &optimised, Plan const *read, Options const &options,
                                     std::string &remark) {
  Graph const &graph = optimised.graph;
  std::ostringstream text;
  if (options.language.text == "graph") {
    write_graph(text, graph);
    return {{options.output, text.str()}};
  }
  std::vector<Language const *> const languages = options.language.languages();
  bool const is_text = languages.empty(); // of the plan for C
  PlanRequest const request{options.passes, options.emitter, options.reroll, options.vector,
                            is_text ? std::vector{find_language("c")} : languages};
  PlannedCode const code =
      read ? planned_code(*read, request)
           : planned_code(options.parallel.shared(schedule(graph, options.emitter.nesting()), remark), optimised.loops,
                          request);
  for (Diagnostic const &diagnostic : code.remarks) print(std::cerr, diagnostic);
  for (std::string const &found : {code.loops, code.lanes})
    if (!found.empty()) remark = found;
  if (is_text) {
    write_plan(text, code.plan());
    return {{options.output, text.str()}};
  }
  std::string const path =
      options.output.empty() ? graph.kernel + std::string(languages[0]->files.extension) : options.output;
  require_source_name(path, languages);
  return emitted_files(code.of(request), options.emitter, options.passes.floating_point(), path);
}

std::vector<std::string> write_bundle(Graph const &graph, Plan const *read, Options const &options) {
  Bundle const bundle = options.bundle.bundle(read ? *read : schedule(graph, options.emitter.nesting()),
                                              options.emitter, options.passes.floating_point(), false);
  Outputs outputs;
  bundle.add_to(outputs);
  return write_outputs(outputs);
}

void run(CLI::App const &command, Options const &options) {
  require_sense(command, options);
  Input input = read_input(options);
  Optimised const optimised = input.plan ? Optimised{*input.plan->graph, {}, counts_of(*input.plan->graph)}
                                         : optimised_graph(std::move(input.graph), options);
  Plan const *const read = input.plan ? &input.plan->plan : nullptr;
  KernelReport report{optimised.recorded, &optimised.graph, optimised.stages, {}, {}};
  if (options.bundle.is_given()) {
    report.files = write_bundle(optimised.graph, read, options);
  } else {
    std::string remark;
    std::vector<OutputFile> files = result_files(optimised, read, options, remark);
    if (!remark.empty()) std::cerr << "kernel " << optimised.graph.kernel << ": " << remark << '\n';
    if (options.output.empty()) {
      std::cout << files.front().text;
    } else {
      report.files = write_outputs({std::move(files)});
    }
  }
  if (options.statistics) print_table(std::cerr, report, true);
  if (options.json) // labels may be invalid UTF-8
    std::cout << to_json(report).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

} // namespace

void add_opt(CLI::App &app, Session &session) {
  CLI::App *command =
      app.add_subcommand("opt", "Run passes on the text of a graph; print the graph or its plan, or emit code");
  auto options = std::make_shared<Options>();
  command
      ->add_option("graph", options->file,
                   "Graph text, as written by generate --graph; or a plan, as written by --lang=plan")
      ->required();
  command->add_option("-o", options->output, "Output file (default: standard output)")->type_name("FILE");
  options->language.add_to(*command, "graph", "graph|plan");
  options->bundle.add_to(*command);
  options->differentiate.add_to(*command);
  options->passes.add_to(*command);
  options->emitter.add_to(*command);
  options->parallel.add_to(*command);
  options->reroll.add_to(*command);
  options->vector.add_to(*command);
  command->add_flag("--stats", options->statistics, "Print the table of operations to standard error");
  command->add_flag("--json", options->json, "Print the table as JSON to standard output");
  command->callback([options, command, &session] {
    refuse_flags(session);
    run(*command, *options);
  });
}

} // namespace symreal::tool
