#include "engine/emit/c/objects.h"
#include "engine/emit/c/parts.h"
#include "engine/emit/print/remarks.h"
#include "engine/emit/print/source.h"

#include <fmt/format.h>

namespace symreal {

// Index of each object's first element, and a struct of numbers with the objects in order: a pointer to the struct is a
// pointer to the array.
static std::string describe(Emission const &emission, std::string const &role, std::vector<Object> const &objects) {
  auto const [indices, members] = c_objects(emission, role, objects);
  if (members.empty()) return {};
  std::string const type = emission.name(role);
  return fmt::format("enum {{{}\n}};\ntypedef struct {}_values {{\n{}}} {}_values;\n\n", indices, type, members, type);
}

static std::string guard_list(Emission const &emission) {
  if (emission.graph().guards.empty()) return {};
  return guard_remark(emission) +
         fmt::format("enum {{ {} = {} }};\n/* The condition of a guard and its places in the source. */\n"
                     "char const *{}(int guard);\n\n",
                     emission.name("guard_count"), emission.graph().guards.size(), emission.name("guard_text"));
}

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
  out += frozen_remark(emission) + guard_list(emission);
  out += "#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  return out;
}

} // namespace symreal
