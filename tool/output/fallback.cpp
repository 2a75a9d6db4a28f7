#include "tool/output/fallback.h"

#include <cctype>
#include <fmt/format.h>

namespace symreal::tool {

static bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Offset of the function's name in its declaration, behind the return type.
static std::size_t name_in(std::string const &declaration, std::string const &name) {
  std::size_t at = declaration.find(name + "(");
  while (at != 0 && at != declaration.npos && is_word(declaration[at - 1])) at = declaration.find(name + "(", at + 1);
  return at;
}

Fallback fallback(rewrite::Kernel const &kernel, std::string const &name) {
  rewrite::Signature const &signature = kernel.signature;
  Fallback result;
  std::string call;
  std::string declaration = signature.declaration;
  std::size_t const at = name_in(declaration, kernel.name);
  if (signature.arguments && at != declaration.npos) {
    declaration.replace(at, kernel.name.size(), name);
    result.declaration = declaration + ";\n";
    result.way = fmt::format("compile it with -D{}={}", kernel.name, name);
    call = fmt::format("{}({})", name, *signature.arguments);
  } else {
    rewrite::Redefinition const &in = signature.redefinition;
    result.declaration = fmt::format("extern \"C\" {} {}({});\n", in.returned, name, in.parameters);
    result.way = fmt::format("in its object file,\n   objcopy --redefine-sym {}={} OBJECT", in.mangled, name);
    call = fmt::format("{}({}{}{})", name, in.has_this ? "this" : "", in.has_this && !in.arguments.empty() ? ", " : "",
                       in.arguments);
  }
  result.statement = !signature.returns_value ? fmt::format("{{\n    {};\n    return;\n  }}\n", call)
                                              : fmt::format("return {};\n", call);
  return result;
}

} // namespace symreal::tool
