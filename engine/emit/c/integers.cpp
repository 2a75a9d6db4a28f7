#include "engine/emit/c/parts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <string_view>

namespace symreal {

namespace {

struct IntegerFunction {
  std::string_view type, name, parameters, body;
};

constexpr std::array functions = {
#define INTEGER_FUNCTION(type, name, parameters, ...) IntegerFunction{#type, #name, #parameters, #__VA_ARGS__},
#include <symreal/integer_functions.def>
#undef INTEGER_FUNCTION
};

bool is_integer_type_used(OperationInfo const &operation) {
  return operation.form == Form::local || operation.has(flag::WIDE | flag::TAKES_WIDE) ||
         (operation.form == Form::cast && operation.c.find("int") != operation.c.npos);
}

// Whether an operation that passes the test has been printed.
template <class Test> bool any_printed(Emission const &emission, Test test) {
  return std::ranges::any_of(operations(), [&](OperationInfo const &operation) {
    return emission.uses.operations[static_cast<std::size_t>(operation.op)] && test(operation);
  });
}

// Whether the body of one function of the table calls another.
bool calls(std::string_view text, std::string_view function) {
  std::string const call = std::string(function) + "(";
  for (std::size_t at = text.find(call); at != text.npos; at = text.find(call, at + 1)) {
    char const before = at == 0 ? ' ' : text[at - 1];
    if (!std::isalnum(static_cast<unsigned char>(before)) && before != '_') return true;
  }
  return false;
}

// The text in single precision: float for double, with the types, literals and library functions.
std::string in_single(std::string_view text) {
  std::string result;
  auto const is_part = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.'; };
  while (!text.empty()) {
    std::size_t const length = static_cast<std::size_t>(std::ranges::find_if_not(text, is_part) - text.begin());
    std::string const word(text.substr(0, std::max<std::size_t>(length, 1)));
    text.remove_prefix(word.size());
    bool const is_number = std::isdigit(static_cast<unsigned char>(word[0])) && word.find_first_of(".p") != word.npos;
    bool const is_function = std::ranges::any_of(operations(), [&](OperationInfo const &operation) {
      return operation.form == Form::call && operation.c == word;
    });
    result += word == "double" ? "float" : is_number || is_function ? word + "f" : word;
  }
  return result;
}

// Definition of the function, one statement per line.
std::string text_of(IntegerFunction const &function) {
  std::string text = fmt::format("static {} {}{} {{\n", function.type, function.name, function.parameters);
  std::string_view body = function.body;
  while (!body.empty()) {
    std::size_t const end = body.find(';') + 1;
    text += fmt::format("  {}\n", body.substr(0, end));
    body.remove_prefix(std::min(body.size(), body.find_first_not_of(' ', end)));
  }
  return text + "}\n";
}

} // namespace

std::string c_integer_includes(Emission const &emission) {
  return any_printed(emission, is_integer_type_used) ? "#include <stdint.h>\n" : "";
}

std::string c_integer_functions(Emission const &emission) {
  UsedFeatures const &uses = emission.uses;
  std::array<bool, functions.size()> wanted{};
  for (std::size_t k = functions.size(); k-- > 0;) {
    wanted[k] = uses.integer_functions.contains(functions[k].name);
    for (std::size_t user = k + 1; user < functions.size(); ++user)
      wanted[k] = wanted[k] || (wanted[user] && calls(functions[user].body, functions[k].name));
  }
  std::string text;
  for (std::size_t k = 0; k < functions.size(); ++k)
    if (wanted[k]) text += emission.language.is_single ? in_single(text_of(functions[k])) : text_of(functions[k]);
  if (uses.keep_integer)
    text += "static void keep_integer(double *element, uint64_t x) {\n"
            "  unsigned char const *from = (unsigned char const *)&x;\n"
            "  unsigned char *to = (unsigned char *)element;\n"
            "  unsigned k;\n"
            "  for (k = 0u; k < sizeof x; ++k) to[k] = from[k];\n}\n";
  if (uses.kept_integer)
    text += "static uint64_t kept_integer(double const *element) {\n"
            "  uint64_t x;\n"
            "  unsigned char const *from = (unsigned char const *)element;\n"
            "  unsigned char *to = (unsigned char *)&x;\n"
            "  unsigned k;\n"
            "  for (k = 0u; k < sizeof x; ++k) to[k] = from[k];\n"
            "  return x;\n}\n";
  return text.empty() ? text : "/* Integers, as gcc has them on x86-64. */\n" + text + "\n";
}

} // namespace symreal
