#include "engine/emit/cpp/parts.h"

#include "engine/emit/c/parts.h"
#include "engine/emit/print/banner.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

std::string cpp_namespace(std::string const &kernel, std::string const &prefix) {
  if (!prefix.empty()) return prefix;
  std::string const name = identifier(kernel);
  // Names that <cmath> declares in the global namespace are taken.
  auto const spells_it = [&](OperationInfo const &operation) { return operation.c == name; };
  bool const is_taken = name == "std" || name == "main" || std::ranges::any_of(operations(), spells_it);
  return is_taken ? name + "_" : name;
}

std::string cpp_begin(Emission const &emission) {
  return fmt::format("#include \"{}.hpp\"\n\n#include <cmath>\n{}", emission.options.base_name, c_preamble(emission));
}

std::string cpp_external_declarations(Emission const &emission) {
  std::string const text = c_external_declarations(emission);
  return text.empty() ? text : "extern \"C\" {\n" + text.substr(0, text.size() - 1) + "}\n\n";
}

std::string cpp_open(Emission const &emission) { return fmt::format("namespace {} {{\n\n", cpp_namespace(emission)); }

std::string cpp_end(Emission const &emission) {
  return c_guard_text(emission) + fmt::format("\n}} // namespace {}\n", cpp_namespace(emission));
}

namespace {

constexpr char const *nodiscard = "[[nodiscard]] ";

// A struct of numbers alone has no padding, so it has the layout of its array.
std::string structure(Emission const &emission, std::string const &name, std::string const &members,
                      std::size_t count) {
  if (count == 0) return fmt::format("struct {} {{}};\n\n", name);
  return fmt::format("struct {0} {{\n{1}}};\nstatic_assert(sizeof({0}) == {2} * sizeof({3}));\n\n", name, members,
                     count, emission.language.number.name);
}

std::string described(Emission const &emission, std::string const &role, std::string const &type,
                      std::vector<Object> const &objects, std::size_t count) {
  auto const [indices, members] = c_objects(emission, role, objects);
  std::string const first = indices.empty() ? "" : fmt::format("enum : std::size_t {{{}\n}};\n", indices);
  return first + structure(emission, type, members, count);
}

// Overloads for structs, and for spans where the standard has them.
std::string overloads(Emission const &emission, std::string const &result) {
  std::string const give = result == "void" ? "" : "return ";
  return fmt::format(
      "/* The same on structs. */\n"
      "inline void preprocess(Parameters const &parameters, Constants &constants) {{\n"
      "  preprocess(reinterpret_cast<{3} const *>(&parameters), reinterpret_cast<{3} *>(&constants));\n"
      "}}\n"
      "{2}inline {0} compute(Input const &input, Constants const &constants, Output &output) {{\n"
      "  {1}compute(reinterpret_cast<{3} const *>(&input), reinterpret_cast<{3} const *>(&constants),\n"
      "          reinterpret_cast<{3} *>(&output));\n"
      "}}\n\n"
      "#if __cplusplus >= 202002L\n"
      "/* The same on spans. */\n"
      "inline void preprocess(std::span<{3} const, parameter_count> parameters,\n"
      "                       std::span<{3}, constant_count> constants) {{\n"
      "  preprocess(parameters.data(), constants.data());\n"
      "}}\n"
      "{2}inline {0} compute(std::span<{3} const, input_count> input, std::span<{3} const, constant_count> "
      "constants,\n"
      "                    std::span<{3}, output_count> output) {{\n"
      "  {1}compute(input.data(), constants.data(), output.data());\n"
      "}}\n"
      "#endif\n\n",
      result, give, result == "void" ? "" : nodiscard, emission.language.number.name);
}

} // namespace

std::string cpp_header(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::size_t const constants = emission.plan.constant_count;
  std::string const result = graph.guards.empty() ? "void" : "int";
  std::string const real(emission.language.number.name);
  std::string out = banner(emission);
  out += fmt::format(
      "#ifndef {0}\n#define {0}\n\n#include <cstddef>\n#if __cplusplus >= 202002L\n#include <span>\n#endif\n\n"
      "namespace {1} {{\n\n",
      include_guard(emission, "_HPP"), cpp_namespace(emission));
  out += fmt::format("inline constexpr std::size_t input_count = {}, parameter_count = {}, constant_count = {}, "
                     "output_count = {};\n\n",
                     graph.input_count(), graph.parameter_count(), constants, graph.output_count());
  out += described(emission, "input", "Input", graph.inputs, graph.input_count());
  out += described(emission, "parameter", "Parameters", graph.parameters, graph.parameter_count());
  out += structure(emission, "Constants", fmt::format("  {} value[{}];\n", real, constants), constants);
  out += described(emission, "output", "Output", graph.outputs, graph.output_count());
  out += c_matrices(emission);
  out += "/* Once, and again whenever a parameter changes. */\n"
         "void preprocess(" +
         real + " const *parameters, " + real +
         " *constants);\n\n"
         "/* The arrays may overlap: all inputs are read before an output is written. */\n";
  out += (graph.guards.empty() ? "" : nodiscard) + result +
         fmt::format(" compute({0} const *input, {0} const *constants, {0} *output);\n\n", real);
  out += overloads(emission, result) + frozen_remark(emission) + c_guard_list(emission);
  out += fmt::format("}} // namespace {}\n\n#endif\n", cpp_namespace(emission));
  return out;
}

std::string cpp_mainline(Emission const &emission) {
  return mainline(emission,
                  {emission.options.base_name + ".hpp", "#include <cmath>\n#include <cstdio>\n#include <cstdlib>\n",
                   cpp_namespace(emission) + "::"});
}

} // namespace symreal
