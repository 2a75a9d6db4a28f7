#include "tool/fallback.h"

#include "diagnostics/diagnostic.h"

#include <cctype>
#include <fmt/format.h>

namespace symreal::tool {

static bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Where a declaration names its function: before it stands what the function returns.
static std::size_t name_in(std::string const &declaration, std::string const &name) {
  std::size_t at = declaration.find(name + "(");
  while (at != 0 && at != declaration.npos && is_word(declaration[at - 1])) at = declaration.find(name + "(", at + 1);
  return at;
}

Fallback fallback(rewrite::Kernel const &kernel, std::string const &name) {
  std::string declaration = kernel.signature.declaration;
  std::size_t const at = name_in(declaration, kernel.name);
  if (!kernel.signature.arguments || at == declaration.npos)
    fail(DiagnosticId::option_without_effect, kernel.place,
         "--wrapper calls the original where a guard does not hold, but '" + kernel.name + "' is no plain function");
  declaration.replace(at, kernel.name.size(), name);
  std::string const call = fmt::format("{}({})", name, *kernel.signature.arguments);
  return {declaration + ";\n", !kernel.signature.returns_value ? fmt::format("{{\n    {};\n    return;\n  }}\n", call)
                                                               : fmt::format("return {};\n", call)};
}

} // namespace symreal::tool
