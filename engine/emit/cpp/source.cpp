#include "engine/emit/c/externals.h"
#include "engine/emit/c/parts.h"
#include "engine/emit/cpp/parts.h"

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
  return fmt::format("#include \"{}.hpp\"\n\n#include <cmath>\n{}{}{}{}{}{}{}\n", emission.options.base_name,
                     c_integer_includes(emission), c_sine_and_cosine(emission), c_value_checks(emission),
                     c_no_fusion(emission), c_apart(emission), c_quiet_pragmas(emission), c_vectors(emission));
}

std::string cpp_external_declarations(Emission const &emission) {
  std::string const text = c_external_declarations(emission);
  return text.empty() ? text : "extern \"C\" {\n" + text.substr(0, text.size() - 1) + "}\n\n";
}

std::string cpp_open(Emission const &emission) { return fmt::format("namespace {} {{\n\n", cpp_namespace(emission)); }

std::string cpp_end(Emission const &emission) {
  return c_guard_text(emission) + fmt::format("\n}} // namespace {}\n", cpp_namespace(emission));
}

std::string cpp_mainline(Emission const &emission) {
  return mainline(emission,
                  {emission.options.base_name + ".hpp", "#include <cmath>\n#include <cstdio>\n#include <cstdlib>\n",
                   cpp_namespace(emission) + "::"});
}

} // namespace symreal
