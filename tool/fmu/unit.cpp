#include "tool/fmu/unit.h"

#include "engine/emit/emit.h"
#include "engine/emit/print/module.h"
#include "engine/emit/print/recorded.h"
#include "engine/emit/print/source.h"
#include "engine/graph/names.h"
#include "program/build/durable_files.h"
#include "tool/fmu/archive.h"
#include "tool/fmu/fmi3_declarations.h"
#include "tool/fmu/fmi3_functions.h"
#include "tool/fmu/fmi3_step.h"
#include "tool/fmu/model_description.h"
#include "tool/fmu/unit_library.h"
#include "tool/package/externals.h"

#include <algorithm>
#include <filesystem>

namespace symreal::tool {

namespace {

namespace fs = std::filesystem;
using Files = std::vector<std::pair<std::string, std::string>>;

// C code around the generated functions.
std::string fmi3_text(Emission const &emission, std::string const &token, std::vector<UnitVariable> const &variables) {
  std::vector<std::pair<std::size_t, std::size_t>> states; // pairs of state and derivative
  std::vector<double> start(variables.size(), 0);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    if (variables[k].role == UnitVariable::Role::derivative) states.emplace_back(variables[k].state, k);
    start[k] = variables[k].start;
  }
  std::ranges::sort(states);
  std::vector<std::string> at, derivative_at;
  for (auto const &[state, derivative] : states) {
    at.push_back(std::to_string(state));
    derivative_at.push_back(std::to_string(derivative));
  }
  Language const &c = emission.language;
  Filling fill = module_facts(emission);
  fill.set("token", token).set("states", states.size());
  fill.set("state_places", lines_of(c, at)).set("derivative_places", lines_of(c, derivative_at));
  fill.set("start_values", lines_of(c, constants(c, start)));
  fill.set("constants_or_one", std::max<std::size_t>(1, emission.plan.constant_count));
  fill.set("call", fill(emission.graph().guards.empty() ? fmi3_call : fmi3_checked_call));
  std::string text = banner(emission) + fill(fmi3_declarations);
  for (std::string_view const part : {fmi3_functions, fmi3_step, fmi3_refused}) text += part;
  return text;
}

// Token of a unit: a hash of everything generated for it.
std::string token_of(Files const &files, std::vector<UnitVariable> const &variables) {
  std::string text = model_description({}, variables);
  for (auto const &[name, content] : files) text += content;
  return program::content_hash(text).substr(0, 32);
}

// Bytes of a unit. The sources omit the original's mathematical library, so that the graph's text determines them.
std::string unit_bytes(Schedule const &plan, EmitterOptions const &emitter, FloatingPoint mode) {
  Graph const &graph = *plan.graph;
  Language const &c = *find_language("c");
  std::string const name = identifier(emitter.prefix.empty() ? graph.kernel : emitter.prefix);
  EmitOptions const options{.base_name = name,
                            .prefix = emitter.prefix,
                            .mode = mode,
                            .trace_comments = emitter.trace_comments,
                            .check_values = emitter.check_values};
  std::vector<UnitVariable> const variables = unit_variables(graph);
  Files sources;
  for (EmittedFile const &file : symreal::emit(plan, c, options)) sources.emplace_back(file.name, file.text);
  UnitNames const names{graph.kernel, name, token_of(sources, variables)};
  sources.emplace_back(name + "_fmi3.c", fmi3_text({plan, c, options}, names.token, variables));
  Files files = {{"modelDescription.xml", model_description(names, variables)}};
  std::vector<std::string> compiled;
  for (auto const &[file, text] : sources) {
    files.emplace_back("sources/" + file, text);
    if (file.ends_with(".c")) compiled.push_back(file);
  }
  files.emplace_back("sources/buildDescription.xml", build_description(name, compiled, unit_compiler_options));
  files.emplace_back("binaries/" + unit_platform() + "/" + name + ".so", unit_library(sources));
  return archive(files);
}

} // namespace

void UnitOption::add_to(CLI::App &app) {
  app.add_option("--fmu", file, "Write a functional mock-up unit (FMI 3.0) of a kernel with states, in place of -o")
      ->type_name("FILE");
}

void UnitOption::require_sense(CLI::App &command) const {
  if (!is_given()) return;
  require_no_source_options(command, "--fmu");
  bool const is_directory = file.ends_with('/') || fs::is_directory(file);
  if (!is_directory && fs::path(file).has_extension() && fs::path(file).extension() != ".fmu")
    fail(DiagnosticId::bad_option, {}, "the result is a file whose name ends in .fmu, not '" + file + "'");
}

OutputFile UnitOption::unit(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                            bool several) const {
  Graph const &graph = *plan.graph;
  require_no_externals(graph);
  if (graph.states.empty())
    fail(DiagnosticId::bad_option, {},
         "kernel '" + graph.kernel +
             "' has no states, and --fmu is for equations of motion: name an input and the output that is its "
             "derivative by time, with state(x, dx) in the pragma; for a function as it is use --lang or --package");
  bool const is_directory = several || file.ends_with('/') || fs::is_directory(file);
  std::string const path = is_directory ? (fs::path(file) / (graph.kernel + ".fmu")).string() : file;
  return {path, unit_bytes(plan, options, mode)};
}

} // namespace symreal::tool
