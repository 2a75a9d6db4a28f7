#include "engine/graph/graph_text.h"
#include "engine/graph/names.h"
#include "engine/optimise/differentiate/differentiate.h"
#include "engine/plan/text/plan_text.h"
#include "engine/support/files.h"
#include "engine/support/math_library.h"
#include "program/record/front.h"
#include "program/wrapper/baked_values.h"
#include "tool/calls/driver_program.h"
#include "tool/commands/generate_options.h"
#include "tool/commands/product.h"
#include "tool/commands/subcommands.h"
#include "tool/output/depfile.h"
#include "tool/output/wrapper.h"
#include "tool/output/write_config.h"
#include "tool/report/console.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

// Graphs of a kernel's functions: its own, and with --separate that of its derivatives.
struct FunctionGraphs {
  Graph own;
  std::optional<Graph> derivatives = {};
};

FunctionGraphs differentiated(Graph graph, GenerateOptions const &options, Console &console) {
  auto const report = [&](Diagnostic const &warning) { console.report(warning); };
  if (!options.differentiate.separate) return {options.differentiate.applied(std::move(graph), report)};
  Graph const extended = options.differentiate.applied(graph, report);
  if (extended.outputs.size() == graph.outputs.size())
    fail(DiagnosticId::option_without_effect, {},
         "--separate needs derivatives of '" + graph.kernel + "': name them with --differentiate");
  if (graph.last_effect != no_node)
    fail(DiagnosticId::bad_option, {},
         "--separate: '" + graph.kernel +
             "' calls functions with effects, and a second function would call them again");
  graph.wishes.clear();
  std::size_t const own_outputs = graph.outputs.size();
  return {std::move(graph), derivatives_of(extended, own_outputs)};
}

Optimised optimised(Graph graph, GenerateOptions const &options, Console &console) {
  auto const report = [&](Diagnostic const &one) { console.report(one); };
  return options.reroll.is_given ? optimise_around_loops(std::move(graph), options.passes, options.emitter,
                                                         options.language.languages(), report)
                                 : optimise(std::move(graph), options.passes, report);
}

// The source files, and stages that --dump asks for.
std::vector<OutputFile> files_of(PlannedCode const &code, PlanRequest const &request, GenerateOptions const &options,
                                 std::string const &path) {
  std::vector<OutputFile> files =
      emitted_files(code.of(request), options.emitter, options.passes.floating_point(), path);
  auto const dump = [&](char const *extension, auto const &write) {
    std::ostringstream text;
    write(text);
    files.push_back({fs::path(path).replace_extension(extension).string(), std::move(text).str()});
  };
  if (options.dumps("optimised")) dump(".graph", [&](std::ostream &out) { write_graph(out, *code.plan().graph); });
  if (options.dumps("plan")) dump(".plan", [&](std::ostream &out) { write_plan(out, code.plan()); });
  return files;
}

std::string source_path(program::Recorded const &recorded, GenerateOptions const &options, bool several) {
  std::string const given = recorded.output_file.empty() ? recorded.kernel.name + ".c" : recorded.output_file;
  return place_output(options.output, given, several);
}

// From the graph of a function to its files, a line a stage.
Product product_of(Graph graph, program::Recorded const &recorded, Wrappers &wrappers, GenerateOptions const &options,
                   bool several, Console &console) {
  Product product;
  product.optimised = optimised(std::move(graph), options, console);
  Plan const laid_out = options.parallel.shared(schedule(product.optimised.graph, options.emitter.nesting()),
                                                product.remarks.emplace_back());
  if (options.bundle.is_given()) {
    product.bundle = options.bundle.bundle(laid_out, options.emitter, options.passes.floating_point(), several);
    return product;
  }
  std::string const path = source_path(recorded, options, several);
  PlanRequest const request{options.passes, options.emitter, options.reroll, options.vector,
                            options.language.languages()};
  require_source_name(path, options.output == path ? request.languages : all_languages());
  PlannedCode const code = planned_code(laid_out, product.optimised.loops, request);
  product.tell_of(code);
  product.files = files_of(code, request, options, path);
  if (options.wrapper)
    wrappers.add(recorded, product.optimised.graph, options.emitter, fs::path(path).replace_extension(".c"));
  return product;
}

// Options of the function of derivatives alone, whose file is beside the kernel's.
GenerateOptions options_of_derivatives(GenerateOptions options, fs::path const &path, std::string const &kernel) {
  options.output = (path.parent_path() / (path.stem().string() + "_derivatives" + path.extension().string())).string();
  std::string const &prefix = options.emitter.prefix;
  options.emitter.prefix = identifier(prefix.empty() ? kernel : prefix) + "_derivatives";
  options.wrapper = false;
  options.bundle = {};
  return options;
}

bool accept_frozen(std::vector<program::Recorded> const &kernels, GenerateOptions const &options,
                   program::Talk const &talk, Console &console) {
  if (options.frozen.accepts(kernels, [&](Diagnostic const &one) { console.report(one); })) return true;
  for (program::Recorded const &one : kernels)
    if (!one.clauses.empty()) talk.lacking(one);
  return false;
}

// Options of the kernels, in order. Wrappers of several kernels may be linked into one program, in which each kernel's
// functions need names of their own.
std::vector<GenerateOptions> options_of(std::vector<program::Recorded> const &kernels, GenerateOptions const &options) {
  std::vector<GenerateOptions> all(kernels.size(), options);
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

// Adds what the wrappers must compare. Returns the kernels that have none.
program::Refusals add_baked_values(program::Front &front, program::RunOptions const &run,
                                   GenerateOptions const &options) {
  if (!options.wrapper) return {};
  std::vector<program::Recorded *> functions;
  for (program::Recorded &one : front.kernels) {
    if (!one.graph.wishes.empty() && !options.differentiate.separate)
      fail(DiagnosticId::bad_option, one.graph.wishes.front().place, no_derivatives_in_wrapper);
    if (one.kernel.is_function) functions.push_back(&one);
  }
  return program::add_baked_values(front, program::run_of(front, run), functions);
}

// The products of a kernel: its own, and with --separate that of its derivatives.
std::vector<Product> products_of(program::Recorded &recorded, program::Front const &front, Wrappers &wrappers,
                                 GenerateOptions const &options, Console &console) {
  auto const start = std::chrono::steady_clock::now();
  bool const several = front.kernels.size() > 1;
  (void)find_states(recorded.graph);
  std::ostringstream text;
  if (!options.graph_file.empty()) write_graph(text, recorded.graph);
  FunctionGraphs graphs = differentiated(std::move(recorded.graph), options, console);
  std::vector<Product> products(1);
  if (graphs.derivatives)
    products.push_back(
        product_of(std::move(*graphs.derivatives), recorded, wrappers,
                   options_of_derivatives(options, source_path(recorded, options, several), graphs.own.kernel),
                   /*several=*/false, console));
  Product &own = products.front() = product_of(std::move(graphs.own), recorded, wrappers, options, several, console);
  if (!options.graph_file.empty())
    own.files.push_back(
        {place_output(options.graph_file, recorded.kernel.name + ".graph", several), std::move(text).str()});
  own.exploration = recorded.exploration;
  own.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return products;
}

// The products of all kernels, with their wrappers. Nullopt after an error was reported.
std::optional<std::vector<Product>> with_wrappers(std::vector<std::vector<Product>> kernels, Wrappers &wrappers,
                                                  std::vector<Diagnostic> told, Console &console) {
  std::vector<std::vector<OutputFile>> const files = wrappers.files(told);
  bool is_refused = false;
  for (Diagnostic const &one : told)
    if (one.severity == Severity::error) console.report(one), is_refused = true;
  if (is_refused) return {};
  for (std::size_t k = 0; k < files.size(); ++k)
    kernels[k].front().files.insert(kernels[k].front().files.end(), files[k].begin(), files[k].end());
  std::vector<Product> products;
  for (std::vector<Product> &kernel : kernels)
    for (Product &one : kernel) products.push_back(std::move(one));
  products.front().warnings.insert(products.front().warnings.end(), told.begin(), told.end());
  return products;
}

// The main job, one line a stage: sources to rewritten text, to programs, to recorded graphs, to products. Nullopt
// after an error was reported.
std::optional<std::vector<Product>> generate(program::FrontRequest const &request, GenerateOptions const &options,
                                             program::Talk const &talk, Console &console, program::Front &front) {
  if (!program::rewrite_sources(request, front, talk)) return {};
  if (!program::build_programs(request, front, talk)) return {};
  if (!program::record_kernels(request, front, talk)) return {};
  if (!accept_frozen(front.kernels, options, talk, console)) return {};
  talk.stage("optimising");
  Wrappers wrappers(front);
  std::vector<GenerateOptions> const options_each = options_of(front.kernels, options);
  std::vector<std::vector<Product>> kernels;
  std::vector<Diagnostic> refused;
  program::Refusals const incomparable = add_baked_values(front, request.run, options);
  for (std::size_t k = 0; k < front.kernels.size(); ++k) try {
      if (auto const one = incomparable.find(&front.kernels[k]); one != incomparable.end())
        throw DiagnosticError(one->second);
      kernels.push_back(products_of(front.kernels[k], front, wrappers, options_each[k], console));
    } catch (DiagnosticError const &error) { // the other kernels may have no wrapper either
      if (error.diagnostic().id != DiagnosticId::no_wrapper) throw;
      refused.push_back(error.diagnostic());
    }
  return with_wrappers(std::move(kernels), wrappers, std::move(refused), console);
}

void write_config(ProjectOptions const &project, std::vector<Lacking> const &lacking, Console &console) {
  std::string const file = project.configuration_file(true);
  write_if_changed(file, with_clauses(file, lacking));
  console.note(file + " now has what the pragma lacks; check it, and run again");
}

// Writes the results; with --check, compares them and returns false if a file differs.
bool write_results(std::vector<Product> const &products, program::Front const &front,
                   program::FrontRequest const &request, GenerateOptions const &options) {
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

int run(CLI::App &command, GenerateOptions &options, Session &session) {
  options.source.project.configure(command, session.configured);
  options.require_sense(command);
  Console console;
  program::FrontRequest request = options.source.request(session.flags);
  options.emitter.reference = math_library();
  options.require_outputs();
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
  auto options = std::make_shared<GenerateOptions>();
  options->add_to(*command);
  command->callback([options, command, &session] { session.status = run(*command, *options, session); });
}

} // namespace symreal::tool
