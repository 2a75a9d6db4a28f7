#include "tool/output/replacement_text.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/mutation/is_dropped.h"
#include "engine/support/text.h"
#include "program/wrapper/baked_values.h"
#include "program/wrapper/wrapper_text.h"
#include "rewrite/text/source_text.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

std::string include_line(rewrite::Include const &include, fs::path const &directory) {
  std::string const name = include.beside.empty() ? include.name : "\"" + path_from(directory, include.beside) + "\"";
  return "#include " + name + "\n";
}

// Function that caches the values that depend on parameters alone, as these change seldom.
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
static double const *{0}symreal_constants_of(double const *symreal_parameters) {{
  static SYMREAL_PER_THREAD int symreal_is_known = 0;
  static SYMREAL_PER_THREAD double symreal_known[{1}], symreal_constants[{2}];
  if (!symreal_is_known || __builtin_memcmp(symreal_known, symreal_parameters, sizeof symreal_known) != 0) {{
    {0}preprocess(symreal_parameters, symreal_constants);
    __builtin_memcpy(symreal_known, symreal_parameters, sizeof symreal_known);
    symreal_is_known = 1;
  }}
  return symreal_constants;
}}
)",
                     prefix, graph.parameter_count(), graph.precomputed.size());
}

constexpr char const *refuse_functions = R"(
/* The generated code is for the extents with which it was recorded, and for the values that are baked in. */
static inline void symreal_refuse_extents(char const *symreal_what) {
  fprintf(stderr, "%s: this call has other extents than the generated code\n", symreal_what);
  abort();
}
static inline void symreal_refuse(char const *symreal_what) {
  fprintf(stderr, "%s: this call has another value than the generated code\n", symreal_what);
  abort();
}
)";

// Statements that provide the constants; external functions may reenter the wrapper with other parameters.
std::string constants_statements(Graph const &graph, std::string const &prefix) {
  std::size_t const count = graph.precomputed.size();
  if (count == 0)
    return std::string(graph.parameter_count() == 0 ? "" : "  (void)symreal_parameters;\n") +
           "  double const *const symreal_constants = 0;\n";
  if (graph.parameter_count() == 0)
    return fmt::format("  double symreal_constants[{}];\n  {}preprocess(0, symreal_constants);\n", count, prefix);
  if (graph.externals.empty())
    return fmt::format("  double const *const symreal_constants = {}symreal_constants_of(symreal_parameters);\n",
                       prefix);
  return fmt::format("  double symreal_constants[{0}];\n  __builtin_memcpy(symreal_constants, "
                     "{1}symreal_constants_of(symreal_parameters), sizeof symreal_constants);\n",
                     count, prefix);
}

// Fallback of a wrapper to the original, which the user provides under another name, on calls that the generated code
// does not cover.
struct Fallback {
  std::string declaration; // declares the original as `name`
  std::string statement;   // calls it with the wrapper's arguments and returns
  std::string way;         // instructions for renaming the original
};

// Offset of the function's name in its declaration, behind the return type.
std::size_t name_in(std::string const &declaration, std::string const &name) {
  std::size_t at = declaration.find(name + "(");
  while (at != 0 && at != declaration.npos && rewrite::is_word(declaration[at - 1]))
    at = declaration.find(name + "(", at + 1);
  return at;
}

// A plain function is compiled under another name; for any other (in a namespace, a member, overloaded), the symbol in
// the object file is renamed and called with C linkage.
Fallback fallback(rewrite::Kernel const &kernel, std::string const &name) {
  rewrite::Signature const &signature = kernel.signature;
  Fallback result;
  std::string call;
  std::string declaration = signature.declaration;
  std::size_t const at = name_in(declaration, kernel.name);
  if (signature.arguments && at != declaration.npos) {
    declaration.replace(at, kernel.name.size(), name);
    result.declaration = declaration + ";\n";
    result.way = fmt::format("compile it with -D{}={}", kernel.name, name);
    call = fmt::format("{}({})", name, *signature.arguments);
  } else {
    rewrite::Redefinition const &in = signature.redefinition;
    result.declaration = fmt::format("extern \"C\" {} {}({});\n", in.returned, name, in.parameters);
    result.way = fmt::format("in its object file,\n   objcopy --redefine-sym {}={} OBJECT", in.mangled, name);
    call = fmt::format("{}({}{}{})", name, in.has_this ? "this" : "", in.has_this && !in.arguments.empty() ? ", " : "",
                       in.arguments);
  }
  result.statement = !signature.returns_value ? fmt::format("{{\n    {};\n    return;\n  }}\n", call)
                                              : fmt::format("return {};\n", call);
  return result;
}

// Statements for calls that the generated code does not cover.
std::string other_calls(program::Recorded const &recorded, std::vector<program::ExtentCheck> const &extents,
                        Fallback const *original) {
  std::string text;
  for (program::ExtentCheck const &check : extents)
    text += original ? fmt::format("  if ({}) {}", check.differs, original->statement)
                     : fmt::format("  if ({}) symreal_refuse_extents({});\n", check.differs, in_quotes(check.label));
  if (recorded.baked.empty()) return text;
  if (!original) return text + program::baked_checks(recorded, program::Otherwise::refuse);
  return text + "  int symreal_same = 1;\n" + program::baked_checks(recorded, program::Otherwise::remember) +
         fmt::format("  if (!symreal_same) {}", original->statement);
}

std::string packing(rewrite::Kernel const &kernel, Graph const &graph, std::string const &prefix) {
  return program::wrapper_arrays(graph) + program::wrapper_pack(kernel, "input", graph.inputs, "symreal_input") +
         program::wrapper_pack(kernel, "parameter", graph.parameters, "symreal_parameters") +
         constants_statements(graph, prefix);
}

std::string unpacking(rewrite::Kernel const &kernel, Graph const &graph) {
  return program::wrapper_unpack(kernel, graph.outputs,
                                 [](std::string const &value) { return "return " + value + ";"; });
}

std::string call_of(std::string const &prefix) {
  return prefix + "compute(symreal_input, symreal_constants, symreal_output)";
}

bool caches(Graph const &graph) { return !graph.precomputed.empty() && graph.parameter_count() != 0; }

std::string indented(std::string const &text, std::string const &by) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t const end = std::min(text.find('\n', begin), text.size());
    result += (end == begin ? "" : by) + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return result;
}

} // namespace

void require_replaceable(rewrite::Kernel const &kernel) {
  if (!kernel.is_function)
    fail(DiagnosticId::no_wrapper, kernel.place,
         "--wrapper needs a function: kernel '" + kernel.name + "' is a stretch of code without a signature");
  bool const returns_output = std::any_of(kernel.annotations.begin(), kernel.annotations.end(),
                                          [](auto const &one) { return one.expression == "return"; });
  if (std::string const &obstacle = kernel.signature.redefinition.result.obstacle;
      !obstacle.empty() && !is_dropped("SYM095"))
    fail(DiagnosticId::no_wrapper, kernel.place,
         fmt::format("--wrapper cannot take the place of '{}': {}", kernel.name, obstacle));
  if (kernel.signature.returns_value && !returns_output)
    fail(DiagnosticId::no_wrapper, kernel.place,
         "--wrapper cannot return what '" + kernel.name + "' returns, which is not an output: add output(return)");
}

fs::path real_path(fs::path const &path) {
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(path.empty() ? "." : path), error);
}

std::string path_from(fs::path const &directory, fs::path const &file) {
  fs::path const from = real_path(directory);
  bool const is_near = std::next(from.begin()) != from.end() && *std::next(from.begin()) == *std::next(file.begin());
  return is_near ? file.lexically_relative(from).string() : file.string();
}

std::string c_declarations(Graph const &graph, std::string const &prefix) {
  return fmt::format("#ifdef __cplusplus\nextern \"C\" {{\n#endif\n"
                     "void {0}preprocess(double const *, double *);\n"
                     "{1} {0}compute(double const *, double const *, double *);\n"
                     "#ifdef __cplusplus\n}}\n#endif\n",
                     prefix, graph.guards.empty() ? "void" : "int");
}

std::vector<std::string> preamble(program::Recorded const &recorded, Graph const &graph, std::string const &prefix) {
  std::vector<std::string> blocks = program::baked_helpers(recorded);
  std::vector<std::string> const templates = program::wrapper_templates(recorded.kernel, graph);
  blocks.insert(blocks.end(), templates.begin(), templates.end());
  if (caches(graph)) blocks.push_back(constants_function(graph, prefix));
  return blocks;
}

std::string own_file(program::Recorded const &recorded, Graph const &graph, std::string const &prefix,
                     fs::path const &directory) {
  rewrite::Kernel const &kernel = recorded.kernel;
  rewrite::Redefinition const &function = kernel.signature.redefinition;
  bool const has_fallback = !graph.guards.empty();
  Fallback const original = has_fallback ? fallback(kernel, prefix + "fallback") : Fallback();
  std::vector<program::ExtentCheck> const extents = program::wrapper_extents(kernel, graph);
  bool const may_refuse = !has_fallback && (!extents.empty() || !recorded.baked.empty());

  std::string text =
      fmt::format("/* Generated by Symreal: takes the place of the original definition of {}.\n   This file "
                  "belongs to whoever generated it. */\n",
                  function.qualified);
  for (rewrite::Include const &one : function.includes) text += include_line(one, directory);
  if (program::compares_classes(recorded)) text += "#include <typeinfo>\n";
  if (may_refuse) text += "#include <stdio.h>\n#include <stdlib.h>\n";
  text += "\n" + c_declarations(graph, prefix);
  for (std::string const &one : function.declarations) text += one + "\n";
  if (has_fallback)
    text += fmt::format("\n/* The original, called where a guard does not hold: {}. */\n", original.way);
  for (std::string const &block : preamble(recorded, graph, prefix)) text += block;
  if (may_refuse) text += refuse_functions;
  for (std::string const &one : function.namespaces) text += one + " {\n";
  if (has_fallback) text += original.declaration;
  text += "\n" + function.head + " {\n";
  text += other_calls(recorded, extents, has_fallback ? &original : nullptr);
  text += packing(kernel, graph, prefix);
  std::string const call = call_of(prefix);
  text += has_fallback ? fmt::format("  if ({} != 0) {}", call, original.statement) : "  " + call + ";\n";
  text += unpacking(kernel, graph) + "}\n";
  for (std::size_t i = 0; i < function.namespaces.size(); ++i) text += "}\n";
  return text;
}

std::string try_statements(program::Recorded const &recorded, Graph const &graph, std::string const &prefix) {
  std::string checks = program::baked_checks(recorded, program::Otherwise::remember);
  for (program::ExtentCheck const &one : program::wrapper_extents(recorded.kernel, graph))
    checks += fmt::format("  if ({}) symreal_same = 0;\n", one.differs);
  std::string const results = unpacking(recorded.kernel, graph);
  std::string inner = packing(recorded.kernel, graph, prefix);
  std::string const leave = recorded.kernel.signature.returns_value ? "" : "  return;\n";
  if (graph.guards.empty())
    inner += "  " + call_of(prefix) + ";\n" + results + leave;
  else
    inner += fmt::format("  if ({} == 0) {{\n", call_of(prefix)) + indented(results + leave, "  ") + "  }\n";
  if (checks.empty()) return "  {\n" + indented(inner, "  ") + "  }\n";
  return "  {\n    int symreal_same = 1;\n" + indented(checks, "  ") + "    if (symreal_same) {\n" +
         indented(inner, "    ") + "    }\n  }\n";
}

} // namespace symreal::tool
