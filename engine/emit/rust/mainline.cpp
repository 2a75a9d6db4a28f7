#include "engine/emit/print/recorded.h"
#include "engine/emit/print/source.h"
#include "engine/emit/rust/parts.h"
#include "engine/support/quoted.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

namespace {

std::string array(std::string const &name, std::string_view type, std::vector<std::string> const &values) {
  std::string list;
  for (std::string const &value : values) list += (list.empty() ? "" : ", ") + value;
  return fmt::format("    let {}: [{}; {}] = [{}];\n", name, type, values.size(), list);
}

} // namespace

std::string rust_end(Emission const &emission) {
  Graph const &graph = emission.graph();
  if (graph.guards.empty()) return {};
  std::string list;
  for (Guard const &guard : graph.guards) {
    list += "        " + in_quotes(printable(guard_text(graph, guard))) + ",\n";
  }
  return fmt::format(
      "\n/// The condition of a guard and its places in the source.\npub fn {0}(guard: i32) -> &'static str {{\n"
      "    const TEXT: [&str; {1}] = [\n{2}    ];\n"
      "    if guard > 0 && guard <= {1} {{ TEXT[guard as usize - 1] }} else {{ \"\" }}\n}}\n",
      emission.name("guard_text"), graph.guards.size(), list);
}

std::string rust_mainline(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::string const real(emission.language.number.name);
  bool const is_single = emission.language.is_single;
  char const *const read = is_single ? "strtof" : "strtod";
  std::vector<std::string> labels = output_names(emission);
  for (std::string &label : labels) label = '"' + escaped(label) + "\\0\"";
  std::string const guards = graph.guards.empty()
                                 ? "    kernel::" + emission.name("compute") + "(&input, &constants, &mut output);\n"
                                 : fmt::format("    let guard = kernel::{}(&input, &constants, &mut output);\n"
                                               "    if guard != 0 {{\n"
                                               "        eprintln!(\"guard {{}} does not hold: {{}}\", guard, "
                                               "kernel::{}(guard));\n"
                                               "        std::process::exit(1);\n    }}\n",
                                               emission.name("compute"), emission.name("guard_text"));
  return banner(emission) +
         fmt::format(
             "#[path = \"{0}.rs\"]\nmod kernel;\n\n"
             "extern \"C\" {{\n    fn printf(format: *const u8, ...) -> i32;\n    fn fflush(file: *mut u8) -> i32;\n"
             "    fn {1}(text: *const u8, end: *mut u8) -> {2};\n}}\n\n"
             "// Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then\n"
             "// the parameters.\nfn main() {{\n",
             emission.options.base_name, read, real) +
         array("mut input", real, constants(emission.language, graph.input_values)) +
         array("mut parameters", real, constants(emission.language, graph.parameter_values)) +
         array("name", "&str", labels) +
         fmt::format("    let mut constants = [0.0_{3}; {0}];\n    let mut output = [0.0_{3}; {1}];\n"
                     "    for (i, argument) in std::env::args().skip(1).enumerate() {{\n"
                     "        let value = unsafe {{ {4}((argument + \"\\0\").as_ptr(), std::ptr::null_mut()) }};\n"
                     "        if i < input.len() {{\n            input[i] = value;\n"
                     "        }} else if i < input.len() + parameters.len() {{\n"
                     "            parameters[i - input.len()] = value;\n        }}\n    }}\n"
                     "    kernel::{2}(&parameters, &mut constants);\n",
                     emission.plan.constant_count, graph.output_count(), emission.name("preprocess"), real, read) +
         guards + "    for i in 0..output.len() {\n" +
         fmt::format("        unsafe {{ printf(\"%s = %.{}g\\n\\0\".as_ptr(), name[i].as_ptr(), {}) }};\n    }}\n",
                     is_single ? 9 : 17, is_single ? "f64::from(output[i])" : "output[i]") +
         "    unsafe { fflush(std::ptr::null_mut()) };\n}\n";
}

} // namespace symreal
