// Headers of C, and what those of C++ share: objects and index lists of matrices.
#include "engine/emit/c/parts.h"
#include "engine/emit/print/banner.h"
#include "engine/emit/print/code_text.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace symreal {

// Declares numbers, or untagged structs of them: a struct of numbers alone has no padding.
static std::string declare(Language const &language, std::string const &indent, std::string const &name,
                           std::vector<std::size_t> const &extents, std::vector<Member> const &members) {
  if (number_count(extents, members) == 0) return {};
  std::string text = indent + (members.empty() ? std::string(language.number.name) + " " : "struct {\n");
  std::vector<std::string> const names = identifiers(members, language.names);
  for (std::size_t i = 0; i < members.size(); ++i)
    text += declare(language, indent + "  ", names[i], members[i].extents, members[i].members);
  if (!members.empty()) text += indent + "} ";
  text += name;
  for (std::size_t extent : extents) text += fmt::format("[{}]", extent);
  return text + ";\n";
}

ObjectTexts c_objects(Emission const &emission, std::string const &role, std::vector<Object> const &objects) {
  std::vector<std::string> const names = identifiers(objects, emission.language.names);
  ObjectTexts texts;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].count == 0) continue;
    if (!texts.indices.empty()) texts.indices += ",";
    texts.indices += fmt::format("\n  {} = {}", emission.name(role + "_" + names[i]), objects[i].first);
    texts.members += declare(emission.language, "  ", names[i], objects[i].extents, objects[i].members);
  }
  return texts;
}

std::string include_guard(Emission const &emission, std::string const &suffix) {
  std::string name = prefixed(emission.options, emission.options.base_name) + suffix;
  for (char &c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::toupper(c)) : '_';
  return std::isdigit(static_cast<unsigned char>(name[0])) ? "H_" + name : name;
}

namespace {

std::string name_of(Emission const &emission, MatrixText const &matrix, IndexList const &list) {
  return emission.name(matrix.name + "_" + std::string(list.name));
}

// C lacks arrays without elements.
std::size_t length_of(IndexList const &list) { return std::max<std::size_t>(list.values.size(), 1); }

std::string definition(Emission const &emission, MatrixText const &matrix, IndexList const &list) {
  std::string const values = list.values.empty() ? " 0 " : lines_of(emission.language, list.texts());
  return fmt::format("int const {}[{}] = {{{}}};\n", name_of(emission, matrix, list), length_of(list), values);
}

std::string sizes(Emission const &emission, MatrixText const &matrix) {
  std::string text;
  for (auto const &[name, value] : matrix.sizes())
    text += fmt::format("{} {} = {}", text.empty() ? "" : ",", emission.name(matrix.name + "_" + name), value);
  return "enum {" + text + " };\n";
}

} // namespace

std::string c_guard_list(Emission const &emission) {
  if (emission.graph().guards.empty()) return {};
  std::string const count = fmt::format("{} = {}", emission.name("guard_count"), emission.graph().guards.size());
  return guard_remark(emission) +
         (emission.language.has_namespace ? "inline constexpr int " + count + ";" : "enum { " + count + " };") +
         "\n/* The condition of a guard and its places in the source. */\nchar const *" + emission.name("guard_text") +
         "(int guard);\n\n";
}

std::string c_matrices(Emission const &emission) {
  std::string text;
  for (MatrixText const &matrix : matrix_texts(emission)) {
    text += matrix_remark(emission, matrix) + sizes(emission, matrix);
    for (IndexList const &list : matrix.lists)
      text += emission.language.has_namespace
                  ? "inline constexpr " + definition(emission, matrix, list)
                  : fmt::format("extern int const {}[{}];\n", name_of(emission, matrix, list), length_of(list));
    text += "\n";
  }
  return text;
}

std::string c_matrix_lists(Emission const &emission) {
  std::string text;
  for (MatrixText const &matrix : matrix_texts(emission))
    for (IndexList const &list : matrix.lists) text += "\n" + definition(emission, matrix, list);
  return text;
}

namespace {

// Index of each object's first element, and a struct of numbers with the objects in order: a pointer to the struct is a
// pointer to the array.
std::string describe(Emission const &emission, std::string const &role, std::vector<Object> const &objects) {
  auto const [indices, members] = c_objects(emission, role, objects);
  if (members.empty()) return {};
  std::string const type = emission.name(role);
  return fmt::format("enum {{{}\n}};\ntypedef struct {}_values {{\n{}}} {}_values;\n\n", indices, type, members, type);
}

} // namespace

std::string c_header(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::string out = banner(emission);
  out += fmt::format("#ifndef {0}\n#define {0}\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n",
                     include_guard(emission, "_H"));
  out += fmt::format("enum {{ {} = {}, {} = {}, {} = {}, {} = {} }};\n\n", emission.name("input_count"),
                     graph.input_count(), emission.name("parameter_count"), graph.parameter_count(),
                     emission.name("constant_count"), emission.plan.constant_count, emission.name("output_count"),
                     graph.output_count());
  out += describe(emission, "input", graph.inputs);
  out += describe(emission, "parameter", graph.parameters);
  out += describe(emission, "output", graph.outputs) + c_matrices(emission);
  out += "/* Once, and again whenever a parameter changes. */\n";
  std::string_view const real = emission.language.number.name;
  out += fmt::format("void {0}({1} const *parameters, {1} *constants);\n\n", emission.name("preprocess"), real);
  out += "/* The arrays may overlap: all inputs are read before an output is written. */\n";
  out += fmt::format("{0} {1}({2} const *input, {2} const *constants, {2} *output);\n\n",
                     graph.guards.empty() ? "void" : "int", emission.name("compute"), real);
  out += frozen_remark(emission) + c_guard_list(emission);
  out += "#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  return out;
}

} // namespace symreal
