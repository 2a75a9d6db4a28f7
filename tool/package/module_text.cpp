#include "tool/package/module_text.h"

#include "engine/emit/languages/languages.h"
#include "engine/emit/languages/python_module.h"
#include "engine/emit/print/module.h"
#include "engine/emit/print/recorded.h"
#include "engine/emit/print/source.h"
#include "engine/graph/evaluate.h"
#include "tool/package/python_patterns.h"

namespace symreal::tool {

Language package_language() {
  Language python = language_python();
  python.has_namespace = true;
  python.files.kept_when = ",\nwhen the C source is compiled as in setup.py";
  return python;
}

namespace {

std::string functions_text(bool has_guards) {
  std::string text(python_arrays);
  text += package_native;
  text += python_preprocess;
  text += package_preprocess;
  text += "\ndef $compute(input, constants=None, threads=1):\n";
  text += python_places;
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

} // namespace

std::string module_text(Schedule const &plan, EmitOptions const &options) {
  std::string const functions = functions_text(!plan.graph->guards.empty());
  Language python = package_language();
  python.module.begin = package_begin;
  python.module.functions = functions;
  Emission const emission{plan, python, options};
  return banner(emission) + module_begin(emission) + module_end(emission);
}

std::string stub_text(Schedule const &plan, EmitOptions const &options) {
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
  module.functions = stub_functions;
  module.guards_begin = stub_guards;
  module.guard = module.guards_end = {};
  Emission const emission{plan, python, options};
  return banner(emission) + module_begin(emission) + module_end(emission);
}

std::string test_text(Schedule const &plan, EmitOptions const &options) {
  Language const python = package_language();
  Emission const emission{plan, python, options};
  Filling fill = module_facts(emission);
  bool const has_guards = !plan.graph->guards.empty();
  fill.set("output_values", lines_of(python, constants(python, expected_outputs(*plan.graph))));
  fill.set("refused", has_guards ? "kernel.GuardError" : "()");
  return banner(emission) + fill(test_pattern);
}

} // namespace symreal::tool
