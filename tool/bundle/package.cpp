#include "tool/bundle/package.h"

#include "engine/emit/emit.h"
#include "engine/emit/languages/languages.h"
#include "engine/emit/print/banner.h"
#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"
#include "engine/emit/print/module.h"
#include "engine/graph/evaluate.h"
#include "engine/graph/names.h"
#include "tool/bundle/project_patterns.h"
#include "tool/bundle/python_patterns.h"

#include <filesystem>
#include <string>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

// Python without a prefix before names, since the module separates them.
Language package_language() {
  Language python = *find_language("python");
  python.has_namespace = true;
  python.files.kept_when = ",\nwhen the C source is compiled as in setup.py";
  return python;
}

std::string functions_text(bool has_guards) {
  std::string text(package_native);
  text += package_preprocess;
  text += package_compute;
  if (has_guards) text += package_raise;
  return text + "    return output\n\n\n";
}

// Outputs of the graph for the recorded values.
std::vector<double> expected_outputs(Graph const &graph) {
  std::vector<double> const values = evaluate(graph, graph.input_values, graph.parameter_values);
  std::vector<double> outputs;
  for (NodeId const result : graph.results) outputs.push_back(values[result]);
  return outputs;
}

// Text of __init__.py, with the names of the plain module (emit/languages/python.cpp).
std::string module_text(Plan const &plan, EmitOptions const &options) {
  std::string const functions = functions_text(!plan.graph->guards.empty());
  Language python = package_language();
  python.module.begin = package_begin;
  python.module.functions = functions;
  Emission const emission{plan, python, options};
  return banner(emission) + module_begin(emission) + module_end(emission);
}

// Text of __init__.pyi: its types.
std::string stub_text(Plan const &plan, EmitOptions const &options) {
  Language python = package_language();
  ModuleSyntax &module = python.module;
  module.begin = stub_begin;
  module.size = "$name: int\n";
  module.places = {.begin = "${role}_shapes: list[tuple[int, ...]]  # ",
                   .end = "\n",
                   .object = "($extents_comma)",
                   .separator = ", "};
  module.structure = {.begin = "\n\nclass $Role(NamedTuple):\n",
                      .end = "\n",
                      .object = "    $name: ArrayLike  # ($extents_comma)",
                      .separator = "\n"};
  module.packing = {};
  module.functions = stub_functions;
  module.guards_begin = stub_guards;
  module.guard = module.guards_end = {};
  Emission const emission{plan, python, options};
  return banner(emission) + module_begin(emission) + module_end(emission);
}

// Text of the test in the package.
std::string test_text(Plan const &plan, EmitOptions const &options) {
  Language const python = package_language();
  Emission const emission{plan, python, options};
  Filling fill = module_facts(emission);
  bool const has_guards = !plan.graph->guards.empty();
  fill.set("output_values", lines_of(python, constants(python, expected_outputs(*plan.graph))));
  fill.set("refused", has_guards ? "kernel.GuardError" : "()");
  return banner(emission) + fill(test_pattern);
}

std::string batch_text(Plan const &plan, EmitOptions const &options) {
  Emission const emission{plan, *find_language("c"), options};
  Filling fill = module_facts(emission);
  fill.set("call", fill(plan.graph->guards.empty() ? batch_call : batch_checked_call));
  return banner(emission) + fill(batch_pattern);
}

std::string filled(Emission const &emission, std::string_view pattern) {
  return banner(emission) + module_facts(emission)(pattern);
}

} // namespace

std::vector<OutputFile> package_files(Plan const &plan, EmitterOptions const &emitter, FloatingPoint mode,
                                      std::string const &folder) {
  Graph const &graph = *plan.graph;
  Language const python = package_language();
  std::string const name = identifier(emitter.prefix.empty() ? graph.kernel : emitter.prefix, python.names);
  EmitOptions const options{.base_name = name,
                            .prefix = emitter.prefix,
                            .mode = mode,
                            .trace_comments = emitter.debugs("comments"),
                            .check_values = emitter.debugs("values"),
                            .reference = emitter.reference};
  Emission const emission{plan, python, options};
  std::vector<OutputFile> files;
  auto const add = [&](fs::path const &path, std::string text) {
    files.push_back({(fs::path(folder) / path).string(), std::move(text)});
  };
  add("pyproject.toml", filled(emission, pyproject_pattern));
  add("setup.py", filled(emission, setup_pattern));
  add("MANIFEST.in", std::string(manifest_pattern));
  add("README.md", module_facts(emission)(readme_pattern));
  for (EmittedFile const &file : symreal::emit(plan, *find_language("c"), options)) add("c/" + file.name, file.text);
  add("c/" + name + "_batch.c", batch_text(plan, options));
  fs::path const module = fs::path("src") / name;
  add(module / "__init__.py", module_text(plan, options));
  add(module / "__init__.pyi", stub_text(plan, options));
  add(module / "py.typed", "");
  add("tests/test_" + name + ".py", test_text(plan, options));
  return files;
}

} // namespace symreal::tool
