#include "tool/fallback.h"

#include "diagnostics/diagnostic.h"

#include <cctype>
#include <fmt/format.h>
#include <vector>

namespace symreal::tool {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// The parts between the commas of a parameter list, those inside of brackets left alone.
std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (char c : list) {
    if (c == '(' || c == '[' || c == '<') ++depth;
    if (c == ')' || c == ']' || c == '>') --depth;
    if (c == ',' && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

// "double *" of "double *x[3]"; the name is what is cut off. Empty where only a type is left.
std::string parameter_name(std::string part) {
  while (!part.empty() && (part.back() == ' ' || part.back() == ']'))
    part.resize(part.back() == ']' ? part.rfind('[') : part.size() - 1);
  std::size_t begin = part.size();
  while (begin > 0 && is_word(part[begin - 1])) --begin;
  bool const has_type = part.find_first_not_of(' ') < begin;
  return has_type ? part.substr(begin) : "";
}

} // namespace

Fallback fallback(rewrite::Kernel const &kernel, std::string const &name) {
  auto refuse = [&](std::string const &why) {
    fail(DiagnosticId::option_without_effect, kernel.place,
         "--wrapper calls the original where a guard does not hold, but '" + kernel.name + "' " + why);
  };
  std::string const &signature = kernel.signature;
  std::size_t const open = signature.find(kernel.name + "("), close = signature.rfind(')');
  std::string const head = signature.substr(0, open == signature.npos ? 0 : open);
  if (open == signature.npos || head.ends_with("::") || signature.find_first_not_of(' ', close + 1) != signature.npos)
    refuse("is no plain function");
  std::size_t const first = open + kernel.name.size() + 1;
  std::string const list = signature.substr(first, close - first);
  std::string arguments;
  if (!list.empty() && list != "void")
    for (std::string const &part : split(list)) {
      std::string const argument = parameter_name(part);
      if (argument.empty()) refuse("has a parameter without a plain name");
      arguments += (arguments.empty() ? "" : ", ") + argument;
    }
  bool const is_void = head == "void ";
  std::string const call = fmt::format("{}({})", name, arguments);
  return {fmt::format("{}{}({});\n", head, name, list),
          is_void ? fmt::format("{{\n    {};\n    return;\n  }}\n", call) : fmt::format("return {};\n", call)};
}

} // namespace symreal::tool
