#include "tool/bundle/fmu.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/emit/emit.h"
#include "engine/emit/print/banner.h"
#include "engine/emit/print/code_text.h"
#include "engine/emit/print/module.h"
#include "engine/graph/graph.h"
#include "engine/graph/names.h"
#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "engine/support/number.h"
#include "program/build/durable_files.h"
#include "program/build/process.h"
#include "program/build/workspace.h"
#include "tool/bundle/fmi3_declarations.h"
#include "tool/bundle/fmi3_functions.h"
#include "tool/bundle/fmi3_step.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <string>
#include <sys/utsname.h>
#include <vector>
#include <zip.h>

namespace symreal::tool {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>; // names and contents

// Variables of a functional mock-up unit: the numbers of a graph with their FMI attributes.
struct UnitVariable {
  enum class Role { time, input, state, parameter, output, derivative };
  std::string name;
  Role role = Role::time;
  double start = 0;                      // start value of variables set from outside
  std::size_t state = 0;                 // of a derivative: index of its state
  std::vector<std::size_t> dependencies; // of computed variables: indices of inputs, states and parameters
};
using Role = UnitVariable::Role;

void append(std::vector<Object> &all, std::vector<Object> const &objects) {
  all.insert(all.end(), objects.begin(), objects.end());
}

// Names of all objects, made in one list so that they are unique.
std::vector<std::string> names_of(Graph const &graph) {
  std::vector<Object> all = {{.label = "time", .extents = {}}};
  append(all, graph.inputs);
  append(all, graph.parameters);
  append(all, graph.outputs);
  return element_names(all);
}

// Indices of the inputs and parameters that a result depends on.
std::vector<std::size_t> dependencies(Graph const &graph, NodeId result) {
  std::vector<char> seen(graph.nodes.size(), 0);
  std::vector<NodeId> found = {result};
  std::set<std::size_t> leaves;
  seen[result] = 1;
  while (!found.empty()) {
    Node const &node = graph.nodes[found.back()];
    found.pop_back();
    if (node.op == Op::input) leaves.insert(1 + node.slot());
    if (node.op == Op::parameter) leaves.insert(1 + graph.input_count() + node.slot());
    if (is_leaf(node.op)) continue;
    for (NodeId const operand : node.operand)
      if (operand != no_node && !seen[operand]) {
        seen[operand] = 1;
        found.push_back(operand);
      }
  }
  return {leaves.begin(), leaves.end()};
}

// All variables: index 0 is time, then inputs, parameters and outputs in order. The index is the value reference.
std::vector<UnitVariable> unit_variables(Graph const &graph) {
  std::vector<UnitVariable> variables;
  for (std::string const &name : names_of(graph)) variables.push_back({.name = name, .dependencies = {}});
  std::size_t const parameters = 1 + graph.input_count(), outputs = parameters + graph.parameter_count();
  for (std::size_t k = 0; k < graph.input_count(); ++k) {
    variables[1 + k].role = Role::input;
    variables[1 + k].start = graph.input_values[k];
  }
  for (std::size_t k = 0; k < graph.parameter_count(); ++k) {
    variables[parameters + k].role = Role::parameter;
    variables[parameters + k].start = graph.parameter_values[k];
  }
  for (std::size_t k = 0; k < graph.output_count(); ++k) {
    variables[outputs + k].role = Role::output;
    variables[outputs + k].dependencies = dependencies(graph, graph.results[k]);
  }
  for (State const &state : find_states(graph)) {
    Object const &input = graph.inputs[state.input], &output = graph.outputs[state.output];
    for (std::uint32_t k = 0; k < input.count; ++k) {
      variables[1 + input.first + k].role = Role::state;
      variables[1 + input.first + k].dependencies = {1 + input.first + k};
      variables[outputs + output.first + k].role = Role::derivative;
      variables[outputs + output.first + k].state = 1 + input.first + k;
    }
  }
  return variables;
}

struct UnitNames {
  std::string model;      // title
  std::string identifier; // identifier of files and functions
  std::string token;      // token that ties a description to its code
};

std::string escaped(std::string const &text) {
  std::string result;
  for (char const c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

// A double in the syntax of XML Schema.
std::string number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "INF" : "-INF";
  return shortest(value);
}

std::string attributes(UnitVariable const &variable) {
  std::string const start = number(variable.start);
  switch (variable.role) {
  case Role::time: return R"(causality="independent" variability="continuous")";
  case Role::input: return fmt::format(R"(causality="input" variability="continuous" start="{}")", start);
  case Role::state:
    return fmt::format(R"(causality="output" variability="continuous" initial="exact" start="{}")", start);
  case Role::parameter: return fmt::format(R"(causality="parameter" variability="tunable" start="{}")", start);
  case Role::output: return R"(causality="output" variability="continuous" initial="calculated")";
  case Role::derivative: break;
  }
  return fmt::format(R"(causality="local" variability="continuous" initial="calculated" derivative="{}")",
                     variable.state);
}

// Entry of an unknown. `with_parameters`: its dependencies include parameters, which vary only in initialization.
std::string unknown(std::string const &element, std::vector<UnitVariable> const &variables, std::size_t k,
                    bool with_parameters) {
  std::vector<std::size_t> known;
  for (std::size_t const at : variables[k].dependencies)
    if (with_parameters || variables[at].role != Role::parameter) known.push_back(at);
  return fmt::format("    <{} valueReference=\"{}\" dependencies=\"{}\"/>\n", element, k, fmt::join(known, " "));
}

std::string structure(std::vector<UnitVariable> const &variables) {
  std::string outputs, initial, by_state;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    Role const role = variables[k].role;
    if (role == Role::output || role == Role::state) outputs += unknown("Output", variables, k, false);
    if (role == Role::output || role == Role::derivative) initial += unknown("InitialUnknown", variables, k, true);
  }
  // Lists derivatives in the order of the states, as the unit's functions pass them.
  for (std::size_t state = 0; state < variables.size(); ++state)
    for (std::size_t k = 0; k < variables.size(); ++k)
      if (variables[k].role == Role::derivative && variables[k].state == state)
        by_state += unknown("ContinuousStateDerivative", variables, k, false);
  return outputs + by_state + initial;
}

// Text of modelDescription.xml.
std::string model_description(UnitNames const &names, std::vector<UnitVariable> const &variables) {
  std::string list;
  for (std::size_t k = 0; k < variables.size(); ++k)
    list += fmt::format("    <Float64 name=\"{}\" valueReference=\"{}\" {}/>\n", escaped(variables[k].name), k,
                        attributes(variables[k]));
  return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="3.0" modelName="{0}" instantiationToken="{1}" generationTool="Symreal {2}">
  <ModelExchange modelIdentifier="{3}" canGetAndSetFMUState="true"/>
  <CoSimulation modelIdentifier="{3}" canGetAndSetFMUState="true" canHandleVariableCommunicationStepSize="true"/>
  <LogCategories>
    <Category name="logStatusDiscard" description="a guard of the generated code does not hold"/>
    <Category name="logStatusError"/>
  </LogCategories>
  <ModelVariables>
{4}  </ModelVariables>
  <ModelStructure>
{5}  </ModelStructure>
</fmiModelDescription>
)",
                     escaped(names.model), names.token, version, names.identifier, list, structure(variables));
}

// Text of sources/buildDescription.xml.
std::string build_description(std::string const &identifier, std::vector<std::string> const &sources,
                              std::string const &compiler_options) {
  std::string files;
  for (std::string const &source : sources) files += fmt::format("      <SourceFile name=\"{}\"/>\n", source);
  return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiBuildDescription fmiVersion="3.0">
  <BuildConfiguration modelIdentifier="{}">
    <SourceFileSet language="C99" compilerOptions="{}">
{}    </SourceFileSet>
    <Library name="m"/>
  </BuildConfiguration>
</fmiBuildDescription>
)",
                     identifier, compiler_options, files);
}

constexpr char const *unit_compiler_options =
    "-std=c99 -O2 -fno-fast-math -ffp-contract=off -fno-tree-slp-vectorize -fno-builtin-pow -fPIC -fvisibility=hidden";

// Name of this machine's platform in FMI 3.0, such as "x86_64-linux".
std::string unit_platform() {
  utsname machine{};
  internal_check(uname(&machine) == 0);
  return std::string(machine.machine) + "-linux";
}

// Bytes of the shared library that cc compiles from these files; those that end in .h are included.
std::string unit_library(Files const &files) {
  program::Workspace const workspace(false);
  std::vector<std::string> command = {"cc", "-shared"};
  for (std::string &option : program::split_words(unit_compiler_options)) command.push_back(std::move(option));
  for (auto const &[name, text] : files) {
    write_if_changed(workspace.file(name), text);
    if (name.ends_with(".c")) command.push_back(name);
  }
  command.insert(command.end(), {"-lm", "-o", "unit.so"});
  program::Captured const compiled =
      program::capture({.arguments = command, .directory = workspace.path(), .environment = {"LC_ALL=C"}});
  if (compiled.outcome.ending == program::Ending::not_started)
    fail(DiagnosticId::compiler_missing, {}, "'cc' compiles the unit for this machine, and cannot be run");
  if (!compiled.outcome.success())
    fail(DiagnosticId::bad_option, {}, "'cc' cannot compile the unit for this machine:\n" + compiled.output);
  return read_file(workspace.file("unit.so"));
}

// Bytes of a ZIP archive. Equal files give equal bytes: time stamps are fixed. It works in memory, so only allocation
// can fail.
std::string archive(Files const &files) {
  constexpr zip_uint16_t first_day = (1U << 5U) | 1U; // of 1980, the format's epoch
  zip_source_t *const buffer = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  internal_check(buffer != nullptr);
  zip_source_keep(buffer);
  zip_t *const zip = zip_open_from_source(buffer, ZIP_TRUNCATE, nullptr);
  internal_check(zip != nullptr);
  for (auto const &[name, text] : files) {
    zip_source_t *const source = zip_source_buffer(zip, text.data(), text.size(), 0);
    zip_int64_t const index = zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    internal_check(index >= 0);
    internal_check(zip_file_set_dostime(zip, static_cast<zip_uint64_t>(index), 0, first_day, 0) == 0);
  }
  internal_check(zip_close(zip) == 0);
  zip_stat_t about;
  internal_check(zip_source_open(buffer) == 0 && zip_source_stat(buffer, &about) == 0);
  std::string bytes(about.size, '\0');
  internal_check(zip_source_read(buffer, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size()));
  zip_source_close(buffer);
  zip_source_free(buffer);
  return bytes;
}

// C code around the generated functions.
std::string fmi3_text(Emission const &emission, std::string const &token, std::vector<UnitVariable> const &variables) {
  std::vector<std::pair<std::size_t, std::size_t>> states; // pairs of state and derivative
  std::vector<double> start(variables.size(), 0);
  for (std::size_t k = 0; k < variables.size(); ++k) {
    if (variables[k].role == Role::derivative) states.emplace_back(variables[k].state, k);
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

} // namespace

std::string unit_bytes(Plan const &plan, EmitterOptions const &emitter, FloatingPoint mode) {
  Graph const &graph = *plan.graph;
  if (graph.states.empty())
    fail(DiagnosticId::bad_option, {},
         "kernel '" + graph.kernel +
             "' has no states, and --fmu is for equations of motion: name an input and the output that is its "
             "derivative by time, with state(x, dx) in the pragma; for a function as it is use --lang or --package");
  Language const &c = *find_language("c");
  std::string const name = identifier(emitter.prefix.empty() ? graph.kernel : emitter.prefix);
  EmitOptions const options{.base_name = name,
                            .prefix = emitter.prefix,
                            .mode = mode,
                            .trace_comments = emitter.debugs("comments"),
                            .check_values = emitter.debugs("values")};
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

} // namespace symreal::tool
