#include "tool/output/wrapper.h"

#include "program/wrapper_text.h"
#include "tool/output/fallback.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

void require_sense(rewrite::Kernel const &kernel) {
  if (!kernel.is_function)
    fail(DiagnosticId::no_wrapper, kernel.place,
         "--wrapper needs a function: kernel '" + kernel.name + "' is a stretch of code without a signature");
  bool const returns_output = std::any_of(kernel.annotations.begin(), kernel.annotations.end(),
                                          [](auto const &one) { return one.expression == "return"; });
  if (kernel.signature.returns_value && !returns_output)
    fail(DiagnosticId::no_wrapper, kernel.place,
         "--wrapper cannot return what '" + kernel.name + "' returns, which is no output: add output(return)");
  if (std::string const &obstacle = kernel.signature.redefinition.obstacle; !obstacle.empty())
    fail(DiagnosticId::no_wrapper, kernel.place,
         "--wrapper cannot take the place of '" + kernel.signature.redefinition.qualified + "': " + obstacle);
}

// A header beside the original is named from where the wrapper is, unless they share no directory but the root.
std::string include_line(rewrite::Include const &include, fs::path const &directory) {
  std::error_code error;
  fs::path const from = fs::weakly_canonical(directory.empty() ? "." : directory, error);
  fs::path const header(include.beside);
  bool const is_near = !include.beside.empty() && !error && std::next(from.begin()) != from.end() &&
                       *std::next(from.begin()) == *std::next(header.begin());
  std::string const name = is_near ? "\"" + header.lexically_relative(from).string() + "\"" : include.name;
  return "#include " + name + "\n";
}

std::string warn_of_missing(rewrite::Kernel const &kernel, std::vector<Diagnostic> &warnings) {
  std::vector<std::string> const &missing = kernel.signature.redefinition.missing;
  if (missing.empty()) return "";
  std::string const names = fmt::format("{}", fmt::join(missing, ", "));
  warnings.push_back(
      {DiagnosticId::wrapper_needs_source, kernel.place,
       fmt::format("the wrapper of '{}' cannot be compiled alone: only {} has {}", kernel.name, kernel.source, names)});
  return fmt::format(
      "/* Only the original's file has {}: include this file there, behind them, in place of the function. "
      "*/\n",
      names);
}

// Parameters change seldom, so what depends on them alone is kept.
std::string constants_function(Graph const &graph, std::string const &prefix) {
  return fmt::format(R"(
#ifndef SYMREAL_PER_THREAD
#if defined __cplusplus
#define SYMREAL_PER_THREAD thread_local
#elif defined __GNUC__
#define SYMREAL_PER_THREAD __thread
#elif defined __STDC_VERSION__ && __STDC_VERSION__ >= 201112L
#define SYMREAL_PER_THREAD _Thread_local
#else
#error "no variables of a thread's own: if one thread alone calls the function, define SYMREAL_PER_THREAD as nothing"
#endif
#endif

/* What depends on parameters alone. {0}preprocess runs in a thread's first call and when a parameter has other bits than in the
   thread's last call: so a NaN is equal to itself, and 0.0 is not -0.0. */
static double const *symreal_constants_of(double const *symreal_parameters) {{
  static SYMREAL_PER_THREAD int symreal_is_known = 0;
  static SYMREAL_PER_THREAD double symreal_known[{1}], symreal_constants[{2}];
  if (!symreal_is_known || memcmp(symreal_known, symreal_parameters, sizeof symreal_known) != 0) {{
    {0}preprocess(symreal_parameters, symreal_constants);
    memcpy(symreal_known, symreal_parameters, sizeof symreal_known);
    symreal_is_known = 1;
  }}
  return symreal_constants;
}}
)",
                     prefix, graph.parameter_count(), graph.precomputed.size());
}

constexpr char const *refuse_function = R"(
/* The generated code is for the extents with which it was recorded. */
static void symreal_refuse(char const *symreal_what) {
  fprintf(stderr, "%s: this call has other extents than the generated code\n", symreal_what);
  abort();
}
)";

// Functions that the generated code calls may call the wrapper again, with other parameters.
std::string constants_statements(Graph const &graph, std::string const &prefix) {
  std::size_t const count = graph.precomputed.size();
  if (count == 0)
    return std::string(graph.parameter_count() == 0 ? "" : "  (void)symreal_parameters;\n") +
           "  double const *const symreal_constants = 0;\n";
  if (graph.parameter_count() == 0)
    return fmt::format("  double symreal_constants[{}];\n  {}preprocess(0, symreal_constants);\n", count, prefix);
  if (graph.externals.empty())
    return "  double const *const symreal_constants = symreal_constants_of(symreal_parameters);\n";
  return fmt::format("  double symreal_constants[{}];\n  memcpy(symreal_constants, "
                     "symreal_constants_of(symreal_parameters), sizeof symreal_constants);\n",
                     count);
}

std::string c_declarations(Graph const &graph, std::string const &prefix) {
  std::string text = fmt::format("#ifdef __cplusplus\nextern \"C\" {{\n#endif\n"
                                 "void {0}preprocess(double const *parameters, double *constants);\n"
                                 "{1} {0}compute(double const *input, double const *constants, double *output);\n"
                                 "#ifdef __cplusplus\n}}\n#endif\n",
                                 prefix, graph.guards.empty() ? "void" : "int");
  return text;
}

// Statements for a call that the generated code is not for.
std::string other_extents(std::vector<program::ExtentCheck> const &checks, bool has_fallback,
                          Fallback const &original) {
  std::string text;
  for (program::ExtentCheck const &check : checks)
    text += has_fallback ? fmt::format("  if ({}) {}", check.differs, original.statement)
                         : fmt::format("  if ({}) symreal_refuse(\"{}\");\n", check.differs, check.label);
  return text;
}

} // namespace

OutputFile wrapper_file(rewrite::Kernel const &kernel, Graph const &graph, EmitterOptions const &options,
                        std::string const &generated, std::vector<Diagnostic> &warnings) {
  require_sense(kernel);
  rewrite::Redefinition const &function = kernel.signature.redefinition;
  std::string const prefix = options.prefix.empty() ? "" : options.prefix + "_";
  fs::path const directory = fs::path(generated).parent_path();
  bool const has_fallback = !graph.guards.empty();
  Fallback const original = has_fallback ? fallback(kernel, prefix + "fallback") : Fallback();
  std::vector<program::ExtentCheck> const extents = program::wrapper_extents(kernel, graph);
  bool const caches = !graph.precomputed.empty() && graph.parameter_count() != 0;

  std::string text =
      fmt::format("/* Generated by Symreal: takes the place of the original definition of {}.\n   This file "
                  "belongs to whoever generated it. */\n",
                  function.qualified);
  text += warn_of_missing(kernel, warnings);
  for (rewrite::Include const &one : function.includes) text += include_line(one, directory);
  if (caches) text += "#include <string.h>\n";
  if (!extents.empty() && !has_fallback) text += "#include <stdio.h>\n#include <stdlib.h>\n";
  text += "\n" + c_declarations(graph, prefix);
  for (std::string const &one : function.declarations) text += one + "\n";
  if (has_fallback)
    text += fmt::format("\n/* The original, called where a guard does not hold: {}. */\n", original.way);
  std::string const templates = program::wrapper_templates(kernel, graph);
  if (!templates.empty()) text += "\n" + templates;
  if (caches) text += constants_function(graph, prefix);
  if (!extents.empty() && !has_fallback) text += refuse_function;
  for (std::string const &one : function.namespaces) text += one + " {\n";
  if (has_fallback) text += original.declaration;
  text += "\n" + function.head + " {\n";
  text += other_extents(extents, has_fallback, original);
  text += program::wrapper_arrays(graph);
  text += program::wrapper_pack(kernel, "input", graph.inputs, "symreal_input");
  text += program::wrapper_pack(kernel, "parameter", graph.parameters, "symreal_parameters");
  text += constants_statements(graph, prefix);
  std::string const call = prefix + "compute(symreal_input, symreal_constants, symreal_output)";
  text += has_fallback ? fmt::format("  if ({} != 0) {}", call, original.statement) : "  " + call + ";\n";
  text += program::wrapper_unpack(kernel, graph.outputs, [](rewrite::Annotation const &, std::string const &value) {
    return "return " + value + ";";
  });
  text += "}\n";
  for (std::size_t i = 0; i < function.namespaces.size(); ++i) text += "}\n";
  std::string const suffix = fs::path(kernel.source).extension() == ".c" ? ".c" : ".cpp";
  return {(directory / (fs::path(generated).stem().string() + "_wrapper" + suffix)).string(), text};
}

} // namespace symreal::tool
