#include "emit/c/parts.h"
#include "graph/names.h"

#include <cctype>
#include <fmt/format.h>

namespace symreal {

static std::string include_guard(EmitOptions const &options) {
  std::string name = prefixed(options, options.base_name) + "_H";
  for (char &c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::toupper(c)) : '_';
  return std::isdigit(static_cast<unsigned char>(name[0])) ? "H_" + name : name;
}

// Numbers, or structs of them without tags: a struct of doubles alone has no gaps.
static std::string declare(std::string const &indent, std::string const &name, std::vector<std::size_t> const &extents,
                           std::vector<Member> const &members) {
  if (number_count(extents, members) == 0) return {};
  std::string text = indent + (members.empty() ? "double " : "struct {\n");
  std::vector<std::string> const names = identifiers(members);
  for (std::size_t i = 0; i < members.size(); ++i)
    text += declare(indent + "  ", names[i], members[i].extents, members[i].members);
  if (!members.empty()) text += indent + "} ";
  text += name;
  for (std::size_t extent : extents) text += fmt::format("[{}]", extent);
  return text + ";\n";
}

// The index of each object's first element, and a struct of doubles with the objects in order: a pointer to it is a
// pointer to the array.
static std::string describe(EmitOptions const &options, std::string const &role, std::vector<Object> const &objects) {
  std::vector<std::string> names = identifiers(objects);
  std::string indices, members;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].count == 0) continue;
    if (!indices.empty()) indices += ",";
    indices += fmt::format("\n  {} = {}", prefixed(options, role + "_" + names[i]), objects[i].first);
    members += declare("  ", names[i], objects[i].extents, objects[i].members);
  }
  if (members.empty()) return {};
  std::string type = prefixed(options, role);
  return fmt::format("enum {{{}\n}};\ntypedef struct {}_values {{\n{}}} {}_values;\n\n", indices, type, members, type);
}

std::string c_header(Schedule const &plan, EmitOptions const &options) {
  Graph const &graph = *plan.graph;
  std::string out = c_banner(plan, options);
  out += fmt::format("#ifndef {0}\n#define {0}\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n",
                     include_guard(options));
  out += fmt::format("enum {{ {} = {}, {} = {}, {} = {}, {} = {} }};\n\n", prefixed(options, "input_count"),
                     graph.input_count(), prefixed(options, "parameter_count"), graph.parameter_count(),
                     prefixed(options, "constant_count"), plan.constant_count, prefixed(options, "output_count"),
                     graph.output_count());
  out += describe(options, "input", graph.inputs);
  out += describe(options, "parameter", graph.parameters);
  out += describe(options, "output", graph.outputs);
  out += "/* Once, and again whenever a parameter changes. */\n";
  out += fmt::format("void {}(double const *parameters, double *constants);\n\n", prefixed(options, "preprocess"));
  out += "/* The arrays may overlap: all inputs are read before an output is written. */\n";
  out += fmt::format("{} {}(double const *input, double const *constants, double *output);\n\n",
                     graph.guards.empty() ? "void" : "int", prefixed(options, "compute"));
  out += c_frozen_list(graph);
  if (!graph.guards.empty()) out += c_guard_list(plan, options);
  out += "#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  return out;
}

} // namespace symreal
