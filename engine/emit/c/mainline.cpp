#include "engine/emit/c/parts.h"
#include "engine/emit/print/banner.h"
#include "engine/emit/print/module.h"
#include "engine/support/text.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

// C99 lacks zero-length arrays, so an empty one gets an unread element.
static std::string array(std::string const &type, std::string const &name, std::vector<std::string> const &values) {
  std::string list;
  for (std::string const &value : values) list += (list.empty() ? "" : ",\n    ") + value;
  return fmt::format("  {} {}[{}] = {{{}}};\n", type, name, std::max<std::size_t>(values.size(), 1),
                     list.empty() ? "0" : list);
}

std::string mainline(Emission const &emission, MainlineWords const &words) {
  Graph const &graph = emission.graph();
  std::vector<std::string> labels = output_names(emission);
  for (std::string &label : labels) label = in_quotes(label);

  std::string const real(emission.language.number.name);
  bool const is_single = emission.language.is_single;

  std::string out = banner(emission);
  out += fmt::format("#include \"{}\"\n\n{}\n", words.header, words.includes);
  out += "/* Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the\n"
         "   parameters. */\n";
  out += "int main(int argc, char **argv) {\n";
  out += array(real, "input", constants(emission.language, graph.input_values));
  out += array(real, "parameters", constants(emission.language, graph.parameter_values));
  out += array("char const *const", "name", labels);
  out += fmt::format("  {0} constants[{1}] = {{0}};\n  {0} output[{2}] = {{0}};\n", real,
                     std::max<std::size_t>(emission.plan.constant_count, 1),
                     std::max<std::size_t>(graph.output_count(), 1));
  out += "  int i;\n\n";
  out += fmt::format(
      "  for (i = 1; i < argc; ++i) {{\n    {2} const value = {3}(argv[i], NULL);\n"
      "    if (i <= {0}) input[i - 1] = value;\n    else if (i <= {1}) parameters[i - 1 - {0}] = value;\n"
      "  }}\n",
      graph.input_count(), graph.input_count() + graph.parameter_count(), real, is_single ? "strtof" : "strtod");
  out += fmt::format("  {}(parameters, constants);\n", words.scope + emission.name("preprocess"));
  std::string const call = words.scope + emission.name("compute") + "(input, constants, output);\n";
  out += graph.guards.empty() ? "  " + call
                              : fmt::format("  i = {}  if (i != 0) {{\n"
                                            "    fprintf(stderr, \"guard %d does not hold: %s\\n\", i, {}(i));\n"
                                            "    return 1;\n  }}\n",
                                            call, words.scope + emission.name("guard_text"));
  out += fmt::format("  for (i = 0; i < {}; ++i) printf(\"%s = %.{}g\\n\", name[i], output[i]);\n  return 0;\n}}\n",
                     graph.output_count(), is_single ? 9 : 17);
  return out;
}

std::string c_mainline(Emission const &emission) {
  return mainline(emission, {emission.options.base_name + ".h",
                             "#include <math.h>\n#include <stdio.h>\n#include <stdlib.h>\n", ""});
}

} // namespace symreal
