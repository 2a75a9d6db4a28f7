#include "engine/graph/graph.h"
#include "engine/graph/graph_text.h"
#include "engine/graph/names.h"
#include "engine/optimise/differentiate/differentiate.h"
#include "engine/plan/plan_text.h"
#include "engine/support/files.h"
#include "engine/support/math_library.h"
#include "program/record/front.h"
#include "program/wrapper/baked_values.h"
#include "tool/analysis/parallel_option.h"
#include "tool/bundle/bundle.h"
#include "tool/calls/driver_program.h"
#include "tool/commands/optimise.h"
#include "tool/commands/subcommands.h"
#include "tool/options/code_options.h"
#include "tool/options/option_table.h"
#include "tool/options/pass_options.h"
#include "tool/options/recording_options.h"
#include "tool/options/source_options.h"
#include "tool/output/depfile.h"
#include "tool/output/outputs.h"
#include "tool/output/wrapper.h"
#include "tool/output/write_config.h"
#include "tool/report/console.h"
#include "tool/report/report.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/ostream.h>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

struct Options {
  SourceOptions source;
  PassOptions passes;
  EmitterOptions emitter;
  LanguageOption language;
  BundleOption bundle;
  DifferentiateOption differentiate;
  ParallelOption parallel;
  RerollOption reroll;
  VectorOption vector;
  std::string output, graph_file;
  std::vector<std::string> dump;
  bool dumps(std::string_view stage) const { return std::ranges::find(dump, stage) != dump.end(); }
  DecisionsOption decisions;
  FrozenOption frozen;
  std::string depfile;
  std::string recorded = "source";
  bool records_instructions() const { return recorded == "instructions"; }
  bool check = false, wrapper = false, statistics = false, json = false, write_config = false;
};

bool calls_c(Options const &options) {
  std::vector<Language const *> const languages = options.language.languages();
  return std::ranges::find(languages, find_language("c")) != languages.end();
}

constexpr char const *no_derivatives_in_wrapper =
    "--wrapper defines the original's function, which has no place for derivatives";

void require_sense(CLI::App const &command, Options const &options) {
  require_compatible(command);
  options.bundle.require_sense();
  require_one_language(options.language.languages(), options.emitter);
  if (options.wrapper && !calls_c(options))
    fail(DiagnosticId::option_without_effect, {}, "--wrapper calls generated C: name c among the languages of --lang");
  if (options.wrapper && options.emitter.is_single())
    fail(DiagnosticId::bad_option, {}, "--wrapper hands on doubles: leave --real=float out");
  if (options.wrapper && options.differentiate.is_given() && !options.differentiate.separate)
    fail(DiagnosticId::bad_option, {}, no_derivatives_in_wrapper);
  (void)options.emitter.is_single();
  options.frozen.require_sense();
  options.decisions.require_sense();
  if (options.records_instructions() && options.decisions.of_recording() == "select")
    fail(DiagnosticId::bad_option, {},
         "--decisions=select is about the rewritten text, and --record=instructions rewrites nothing: take guard or "
         "explore");
  (void)options.passes.settings();
  (void)options.passes.names();
}

// Checks the outputs before the work is done.
void require_outputs(Options const &options) {
  // If there are several kernels, known only later, these may be directories still to be created.
  auto may_be_file = [](std::string const &path) { return !path.empty() && !names_directory(path); };
  if (options.check) return;
  if (may_be_file(options.output) && fs::path(options.output).has_extension())
    require_source_name(options.output, options.language.languages());
  std::vector<std::string> paths = {options.emitter.map_file, options.depfile};
  for (std::string const *one : {&options.output, &options.graph_file, &options.bundle.unit})
    if (may_be_file(*one)) paths.push_back(*one);
  require_writable(paths);
}

// Files and report of one kernel.
struct Product {
  Optimised optimised = {};
  std::vector<OutputFile> files = {};
  Bundle bundle = {};
  std::vector<Diagnostic> warnings = {};
  std::vector<std::string> remarks = {};      // in words: threads that share it, sines at the start, loops, vectors
  std::optional<OperationCounts> looped = {}; // operations of compute inside and outside loops
  std::optional<program::Exploration> exploration = {};
  double seconds = 0;
};

// Emits the source files of a kernel.
void emit_sources(Wrappers &wrappers, program::Recorded const &recorded, Schedule const &schedule,
                  Options const &options, bool several, Product &product) {
  std::string given = recorded.output_file.empty() ? recorded.kernel.name + ".c" : recorded.output_file;
  std::string const path = place_output(options.output, given, several);
  std::vector<Language const *> const languages = options.language.languages(), any = all_languages();
  require_source_name(path, options.output == path ? languages : any);
  PlannedCode code = planned_code(schedule, product.optimised.loops, languages,
                                  {options.passes, options.emitter, options.reroll, options.vector});
  product.remarks.insert(product.remarks.end(), {code.angles, code.loops, code.lanes});
  product.looped = code.looped;
  product.warnings.insert(product.warnings.end(), code.remarks.begin(), code.remarks.end());
  auto const dump = [&](char const *extension, auto const &write) {
    std::ostringstream text;
    write(text);
    product.files.push_back({fs::path(path).replace_extension(extension).string(), std::move(text).str()});
  };
  product.files = emitted_files(code.plan, options.emitter, options.passes.floating_point(), languages, path);
  if (options.dumps("optimised")) dump(".graph", [&](std::ostream &out) { write_graph(out, code.plan.graph()); });
  if (options.dumps("plan")) dump(".plan", [&](std::ostream &out) { write_plan(out, code.plan); });
  if (!options.wrapper) return;
  wrappers.add(recorded, product.optimised.graph, options.emitter, fs::path(path).replace_extension(".c"));
}

// Emits the files of a kernel, given its schedule.
void emit_files(Wrappers &wrappers, program::Recorded const &recorded, Schedule const &schedule, Options const &options,
                bool several, Product &product) {
  if (options.bundle.is_given())
    product.bundle = options.bundle.bundle(schedule, options.emitter, options.passes.floating_point(), several);
  else
    emit_sources(wrappers, recorded, schedule, options, several, product);
}

// Optimises the product's graph and schedules it.
Schedule scheduled(Product &product, Graph graph, Options const &options, Console &console) {
  auto const report = [&](Diagnostic const &one) { console.report(one); };
  product.optimised = options.reroll.is_given ? optimise_around_loops(std::move(graph), options.passes, options.emitter,
                                                                      options.language.languages(), report)
                                              : optimise(std::move(graph), options.passes, report);
  return options.parallel.shared(schedule(product.optimised.graph, options.emitter.nesting()),
                                 product.remarks.emplace_back());
}

// The product of --separate: derivatives alone, in a file beside the kernel's.
Product derivative_product(Wrappers &wrappers, program::Recorded const &recorded, std::size_t own_outputs,
                           Options options, bool several, Console &console) {
  Graph const &graph = recorded.graph;
  if (graph.outputs.size() == own_outputs)
    fail(DiagnosticId::option_without_effect, {}, "--separate: nobody asks for derivatives of '" + graph.kernel + "'");
  if (graph.last_effect != no_node)
    fail(DiagnosticId::bad_option, {},
         "--separate: '" + graph.kernel +
             "' calls functions with effects, and a second function would call them again");
  Product product;
  Schedule const schedule = scheduled(product, derivatives_of(graph, own_outputs), options, console);
  std::string const given = recorded.output_file.empty() ? recorded.kernel.name + ".c" : recorded.output_file;
  fs::path const path = place_output(options.output, given, several);
  options.output = (path.parent_path() / (path.stem().string() + "_derivatives" + path.extension().string())).string();
  std::string const &prefix = options.emitter.prefix;
  options.emitter.prefix = identifier(prefix.empty() ? graph.kernel : prefix) + "_derivatives";
  options.wrapper = false;
  emit_sources(wrappers, recorded, schedule, options, /*several=*/false, product);
  return product;
}

bool accept_frozen(std::vector<program::Recorded> const &kernels, Options const &options, program::Talk const &talk,
                   Console &console) {
  if (options.frozen.accepts(kernels, [&](Diagnostic const &one) { console.report(one); })) return true;
  for (program::Recorded const &one : kernels)
    if (!one.clauses.empty()) talk.lacking(one);
  return false;
}

// Options of the kernels, in order. Wrappers of several kernels may be linked into one program, in which each kernel's
// functions need names of their own.
std::vector<Options> options_of(std::vector<program::Recorded> const &kernels, Options const &options) {
  std::vector<Options> all(kernels.size(), options);
  if (!options.wrapper || kernels.size() == 1) return all;
  std::set<std::string> taken;
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    std::string const &given = options.emitter.prefix;
    std::string const base = (given.empty() ? "" : given + "_") + identifier(kernels[k].kernel.name);
    std::string &prefix = all[k].emitter.prefix = base;
    for (int copy = 2; !taken.insert(prefix).second; ++copy) prefix = base + "_" + std::to_string(copy);
  }
  return all;
}

// The products of a kernel: its own, and with --separate that of its derivatives.
std::vector<Product> products_of(program::Recorded &recorded, program::Front const &front, Wrappers &wrappers,
                                 program::RunOptions const &run, Options const &options, Console &console) {
  auto const start = std::chrono::steady_clock::now();
  Product product;
  product.exploration = recorded.exploration;
  (void)find_states(recorded.graph);
  std::ostringstream graph;
  if (!options.graph_file.empty()) write_graph(graph, recorded.graph);
  if (options.wrapper && !recorded.graph.wishes.empty() && !options.differentiate.separate)
    fail(DiagnosticId::bad_option, recorded.graph.wishes.front().place, no_derivatives_in_wrapper);
  if (options.wrapper && recorded.kernel.is_function)
    program::add_baked_values(front, program::run_of(front, run), recorded);
  std::size_t const own_outputs = recorded.graph.outputs.size();
  Graph alone = options.differentiate.separate ? recorded.graph : Graph();
  recorded.graph = options.differentiate.applied(std::move(recorded.graph),
                                                 [&](Diagnostic const &warning) { console.report(warning); });
  bool const several = front.kernels.size() > 1;
  std::optional<Product> derivatives;
  if (options.differentiate.separate) {
    derivatives = derivative_product(wrappers, recorded, own_outputs, options, several, console);
    alone.wishes.clear();
    recorded.graph = std::move(alone);
  }
  Schedule const schedule = scheduled(product, std::move(recorded.graph), options, console);
  emit_files(wrappers, recorded, schedule, options, several, product);
  if (!options.graph_file.empty())
    product.files.push_back(
        {place_output(options.graph_file, recorded.kernel.name + ".graph", several), std::move(graph).str()});
  product.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::vector<Product> all = {std::move(product)};
  if (derivatives) all.push_back(std::move(*derivatives));
  return all;
}

// The main job, one line a stage: sources to rewritten text, to programs, to recorded graphs; and each graph to an
// optimised one, to statements, to files. Nullopt after an error was reported.
std::optional<std::vector<Product>> generate(program::FrontRequest const &request, Options const &options,
                                             program::Talk const &talk, Console &console, program::Front &front) {
  if (!program::rewrite_sources(request, front, talk)) return {};
  if (!program::build_programs(request, front, talk)) return {};
  if (!program::record_kernels(request, front, talk)) return {};
  if (!accept_frozen(front.kernels, options, talk, console)) return {};
  talk.stage("optimising");
  std::vector<Product> products;
  std::vector<std::size_t> own; // of each kernel, its product's number
  Wrappers wrappers(front);
  std::vector<Options> const options_each = options_of(front.kernels, options);
  std::vector<Diagnostic> told;
  for (std::size_t k = 0; k < front.kernels.size(); ++k) try {
      own.push_back(products.size());
      for (Product &one : products_of(front.kernels[k], front, wrappers, request.run, options_each[k], console))
        products.push_back(std::move(one));
    } catch (DiagnosticError const &error) { // the other kernels may have no wrapper either
      if (error.diagnostic().id != DiagnosticId::no_wrapper) throw;
      own.pop_back();
      told.push_back(error.diagnostic());
    }
  std::vector<std::vector<OutputFile>> const files = wrappers.files(told);
  auto const is_refusal = [](Diagnostic const &one) { return one.severity == Severity::error; };
  if (std::ranges::any_of(told, is_refusal)) {
    for (Diagnostic const &one : told)
      if (is_refusal(one)) console.report(one);
    return {};
  }
  for (std::size_t k = 0; k < files.size(); ++k)
    products[own[k]].files.insert(products[own[k]].files.end(), files[k].begin(), files[k].end());
  products.front().warnings.insert(products.front().warnings.end(), told.begin(), told.end());
  return products;
}

void write_config(ProjectOptions const &project, std::vector<Lacking> const &lacking, Console &console) {
  std::string const file = project.configuration_file(true);
  write_if_changed(file, with_clauses(file, lacking));
  console.note(file + " now has what the pragma lacks; check it, and run again");
}

// All files of a product, bundles first.
std::vector<OutputFile const *> all_files(Product const &product) {
  std::vector<OutputFile const *> all;
  for (auto const *list : {&product.bundle.package.files, &product.bundle.units, &product.files})
    for (OutputFile const &file : *list) all.push_back(&file);
  return all;
}

// Are these files on disk with the same content? Writes nothing.
bool check_products(std::vector<Product> const &products) {
  std::vector<OutputFile const *> files;
  for (Product const &product : products)
    for (OutputFile const *file : all_files(product)) files.push_back(file);
  return check_files(files);
}

// All files of the products, with the directories to create.
Outputs outputs_of(std::vector<Product> const &products, std::vector<std::string> const &directories) {
  Outputs outputs;
  for (std::string const &directory : directories)
    if (!directory.empty()) outputs.directories.push_back(directory);
  for (Product const &product : products) {
    product.bundle.add_to(outputs);
    outputs.files.insert(outputs.files.end(), product.files.begin(), product.files.end());
  }
  return outputs;
}

// Prints the table, or JSON on standard output.
void show_products(std::vector<Product> const &products, program::Front const &front, bool details, bool as_json) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (Product const &product : products) {
    KernelReport report{product.optimised.recorded, &product.optimised.graph, product.optimised.stages, {}, {}};
    for (OutputFile const *file : all_files(product)) report.files.push_back(file->path);
    report.seconds = {{"rewrite", front.rewrite_seconds},
                      {"build", front.build_seconds},
                      {"run", front.run_seconds},
                      {"optimise and emit", product.seconds}};
    report.exploration = product.exploration ? &*product.exploration : nullptr;
    report.looped = product.looped;
    print_table(std::cerr, report, details);
    for (std::string const &remark : product.remarks)
      if (!remark.empty()) fmt::print(std::cerr, "  {}\n", remark);
    if (as_json) json.push_back(to_json(report));
  }
  program::ObjectCache const &cache = *front.build.cache;
  if (details)
    fmt::print(std::cerr,
               "sources: {} read, {} as an earlier run read them\n"
               "objects: {} compiled, {} as an earlier run compiled them\n",
               front.rewritten.sources_read, front.rewritten.sources_kept, cache.compiled(), cache.reused());
  if (as_json)
    std::cout << nlohmann::ordered_json{{"kernels", json},
                                        {"sources",
                                         {{"read", front.rewritten.sources_read},
                                          {"reused", front.rewritten.sources_kept}}},
                                        {"objects", {{"compiled", cache.compiled()}, {"reused", cache.reused()}}}}
                     .dump(2)
              << "\n";
}

// Writes the results; with --check, compares them and returns false if a file differs.
bool write_results(std::vector<Product> const &products, program::Front const &front,
                   program::FrontRequest const &request, Options const &options) {
  if (options.check) return check_products(products);
  if (options.wrapper) // directories for functions in headers
    for (Product const &product : products)
      for (OutputFile const &file : product.files)
        if (fs::path const directory = fs::path(file.path).parent_path(); !directory.empty())
          make_directory(directory.string());
  BundleOption const &bundle = options.bundle;
  bool const several = front.kernels.size() > 1;
  Outputs outputs =
      outputs_of(products, several ? std::vector{options.output, options.graph_file, bundle.package, bundle.unit}
                                   : std::vector<std::string>());
  if (!options.depfile.empty()) {
    warn_of_unseen(options.depfile);
    outputs.files.push_back({options.depfile, dependencies(options.depfile, all_files(products.front()).front()->path,
                                                           front, request, options.source.project)});
  }
  write_outputs(outputs);
  return true;
}

int run(CLI::App &command, Options &options, Session &session) {
  options.source.project.configure(command, session.configured);
  require_sense(command, options);
  Console console;
  program::FrontRequest request = options.source.request(session.flags);
  options.emitter.reference = math_library();
  require_outputs(options);
  request.run.decisions = options.decisions.of_recording();
  request.run.paths_met = options.decisions.paths_met;
  request.run.floating_point = options.passes.mode;
  request.run.places = true;
  request.run.from_instructions = options.records_instructions();
  std::vector<Lacking> lacking;
  program::Talk talk = console.talk();
  talk.lacking = [&](program::Recorded const &one) { lacking.push_back({one.kernel, one.clauses}); };
  program::Front front;
  std::optional<std::vector<Product>> products;
  with_driver(request, options.source.project.calls, talk, console,
              [&](program::FrontRequest const &called, program::Talk const &called_talk) {
                products = generate(called, options, called_talk, console, front);
              });
  if (!front.kernels.empty() && options.source.front.keep)
    console.note("the build directory is " + front.workspace->path());
  if (!products) {
    if (options.write_config && !lacking.empty()) write_config(options.source.project, lacking, console);
    return error;
  }
  for (Product const &product : *products)
    for (Diagnostic const &warning : product.warnings) console.report(warning);
  console.clear();
  if (!write_results(*products, front, request, options)) return out_of_date;
  if (!options.check) show_products(*products, front, options.statistics, options.json);
  return clean;
}

} // namespace

void add_generate(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("generate", "Generate code: rewrite, build, run, optimise, emit");
  auto options = std::make_shared<Options>();
  command->add_option("sources", options->source.project.request.sources,
                      "C and C++ sources of the program; with -p by default all of them");
  command->add_option("-o", options->output, "Output file, or directory for several kernels")->type_name("FILE");
  command->add_option("--graph", options->graph_file, "Also write the recorded graph as text")->type_name("FILE");
  command->add_option("--dump", options->dump, "Also write these stages as text beside the output: optimised, plan")
      ->type_name("STAGES")
      ->delimiter(',')
      ->check(CLI::IsMember({"optimised", "plan"}));
  command->add_option("--depfile", options->depfile, "Also write the dependencies of the result as a make rule")
      ->type_name("FILE");
  command->add_flag("--check", options->check, "Write nothing; check whether the existing files are up to date");
  options->language.add_to(*command, "c");
  options->bundle.add_to(*command);
  options->differentiate.add_to(*command);
  options->differentiate.add_separate_to(*command);
  options->passes.add_to(*command);
  options->emitter.add_to(*command);
  options->parallel.add_to(*command);
  options->reroll.add_to(*command);
  options->vector.add_to(*command);
  command->add_flag("--wrapper", options->wrapper,
                    "Also emit a file that defines the function in place of the original");
  options->decisions.add_to(*command);
  command
      ->add_option("--record", options->recorded,
                   "Record the rewritten source, or the instructions that clang 19 emits for the original")
      ->type_name("source|instructions")
      ->check(CLI::IsMember({"source", "instructions"}));
  options->frozen.add_to(*command);
  options->source.add_to(*command);
  command->add_flag("--write-config", options->write_config, "Add the clauses that a pragma lacks to .symreal.yaml");
  command->add_flag("--stats", options->statistics, "Print detailed statistics: every object, every pass");
  command->add_flag("--json", options->json, "Print the table as JSON to standard output");
  command->callback([options, command, &session] { session.status = run(*command, *options, session); });
}

} // namespace symreal::tool
