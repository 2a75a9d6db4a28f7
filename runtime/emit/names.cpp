#include "emit/names.h"

#include <cctype>
#include <set>
#include <string_view>

namespace symreal {

bool is_keyword(std::string_view word) {
  static std::set<std::string_view> const words = {
      "and",       "auto",     "bool",   "break",    "case",    "catch",   "char",      "class",  "const",
      "continue",  "default",  "delete", "do",       "double",  "else",    "enum",      "export", "extern",
      "false",     "float",    "for",    "friend",   "goto",    "if",      "inline",    "int",    "long",
      "namespace", "new",      "not",    "operator", "or",      "private", "protected", "public", "register",
      "restrict",  "return",   "short",  "signed",   "sizeof",  "static",  "struct",    "switch", "template",
      "this",      "throw",    "true",   "try",      "typedef", "union",   "unsigned",  "using",  "virtual",
      "void",      "volatile", "while",  "xor"};
  return words.contains(word);
}

static std::string identifier(std::string const &label) {
  std::string name;
  int brackets = 0;
  for (char c : label) {
    if (c == '[') ++brackets;
    bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    if (brackets == 0 && plain)
      name += c;
    else if (brackets == 0 && !name.empty() && name.back() != '_')
      name += '_';
    if (c == ']') --brackets;
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) || is_keyword(name)) name = "value_" + name;
  while (name.back() == '_') name.pop_back();
  return name;
}

std::vector<std::string> identifiers(std::vector<Object> const &objects) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (Object const &object : objects) {
    std::string base = identifier(object.label), name = base;
    for (int copy = 2; !taken.insert(name).second; ++copy) name = base + "_" + std::to_string(copy);
    names.push_back(name);
  }
  return names;
}

std::string element_name(std::string const &identifier, Object const &object, std::uint32_t element) {
  std::string subscripts;
  for (std::size_t dimension = object.extents.size(); dimension-- > 0;) {
    subscripts = "[" + std::to_string(element % object.extents[dimension]) + "]" + subscripts;
    element = static_cast<std::uint32_t>(element / object.extents[dimension]);
  }
  return identifier + subscripts;
}

} // namespace symreal
