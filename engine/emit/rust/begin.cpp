#include "engine/emit/print/matrices.h"
#include "engine/emit/print/module.h"
#include "engine/emit/print/remarks.h"
#include "engine/emit/rust/parts.h"
#include "engine/graph/names.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace symreal {

namespace {

std::string upper(std::string name) {
  for (char &c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::string size(Emission const &emission, std::string const &name, std::size_t value) {
  return fmt::format("pub const {}: usize = {};\n", upper(emission.name(name)), value);
}

// Offsets of the objects, in a module of their own, since their names are the user's.
std::string places(Emission const &emission, std::string const &role, std::vector<Object> const &objects) {
  NameRules const rules{emission.language.names.keywords, /*ignores_case=*/true}; // names are converted to capitals
  std::vector<std::string> const names = identifiers(objects, rules);
  std::string text;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].count != 0)
      text += fmt::format("    pub const {}: usize = {};\n", upper(names[i]), objects[i].first);
  if (text.empty()) return {};
  return fmt::format("/// The index of the first number of each {0}.\npub mod {1} {{\n{2}}}\n\n", role,
                     emission.name(role + "_at"), text);
}

std::string matrices(Emission const &emission) {
  std::string text;
  for (MatrixText const &matrix : matrix_texts(emission)) {
    text += matrix_remark(emission, matrix);
    for (auto const &[name, value] : matrix.sizes()) text += size(emission, matrix.name + "_" + name, value);
    for (IndexList const &list : matrix.lists)
      text += fmt::format("pub static {}: [usize; {}] = [{}];\n",
                          upper(emission.name(matrix.name + "_" + std::string(list.name))), list.values.size(),
                          lines_of(emission.language, list.texts()));
    text += "\n";
  }
  return text;
}

// C's functions, for bitwise agreement with the other languages that call them. They are hidden, since a compiler would
// replace powers with constant exponents by products that round differently.
std::string library(Emission const &emission) {
  std::span<OperationSpelling const> const exceptions = emission.language.expressions.operations;
  std::string const real(emission.language.number.name);
  std::string declarations, functions;
  for (OperationInfo const &operation : operations()) {
    if (operation.form != Form::call || !emission.uses.operations[static_cast<std::size_t>(operation.op)]) continue;
    if (std::ranges::find(exceptions, operation.op, &OperationSpelling::op) != exceptions.end()) continue;
    std::string parameters, arguments;
    for (unsigned i = 0; i < operation.arity; ++i) {
      std::string const name(1, "xyz"[i]), separator = i == 0 ? "" : ", ";
      parameters += separator + name + ": " + real;
      arguments += separator + (operation.op == Op::pow ? "std::ptr::read_volatile(&" + name + ")" : name);
    }
    declarations += fmt::format("        #[link_name = \"{0}{2}\"]\n        fn c_{0}({1}) -> {3};\n", operation.c,
                                parameters, emission.language.is_single ? "f" : "", real);
    functions +=
        fmt::format("\n    #[inline]\n    pub fn {0}({1}) -> {3} {{\n        unsafe {{ c_{0}({2}) }}\n    }}\n",
                    operation.c, parameters, arguments, real);
  }
  if (functions.empty()) return {};
  return "/// The mathematical library of C.\nmod libm {\n    #[link(name = \"m\")]\n    extern \"C\" {\n" +
         declarations + "    }\n" + functions + "}\n\n";
}

} // namespace

std::string rust_begin(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::string text = "#![allow(dead_code, non_snake_case, non_upper_case_globals, unused_assignments, unused_parens)]\n"
                     "#![allow(clippy::all)]\n\n";
  text += size(emission, "input_count", graph.input_count());
  text += size(emission, "parameter_count", graph.parameter_count());
  text += size(emission, "constant_count", emission.plan.constant_count);
  text += size(emission, "output_count", graph.output_count());
  if (!graph.guards.empty()) text += size(emission, "guard_count", graph.guards.size());
  text += "\n" + places(emission, "input", graph.inputs) + places(emission, "parameter", graph.parameters) +
          places(emission, "output", graph.outputs);
  text += matrices(emission) + frozen_remark(emission);
  if (!graph.guards.empty()) text += guard_remark(emission) + "\n";
  return text + library(emission);
}

} // namespace symreal
