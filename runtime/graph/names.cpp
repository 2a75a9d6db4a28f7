#include "graph/names.h"

#include <algorithm>
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

// Made different from each other.
static std::vector<std::string> numbered(std::vector<std::string> names) {
  std::set<std::string> taken;
  for (std::string &name : names) {
    std::string const base = name;
    for (int copy = 2; !taken.insert(name).second; ++copy) name = base + "_" + std::to_string(copy);
  }
  return names;
}

std::vector<std::string> identifiers(std::vector<Object> const &objects) {
  std::vector<std::string> names;
  for (Object const &object : objects) names.push_back(identifier(object.label));
  return numbered(std::move(names));
}

std::vector<std::string> identifiers(std::vector<Member> const &members) {
  std::vector<std::string> names;
  for (Member const &member : members) {
    bool const is_plain = std::all_of(member.name.begin(), member.name.end(),
                                      [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    names.push_back(is_plain && !is_keyword(member.name) ? member.name : identifier(member.name));
  }
  return numbered(std::move(names));
}

static std::string element_name(std::string const &name, std::vector<std::size_t> const &extents,
                                std::vector<Member> const &members, std::size_t number) {
  std::size_t const each = number_count({}, members);
  std::size_t element = number / each, rest = number % each;
  std::string subscripts;
  for (std::size_t dimension = extents.size(); dimension-- > 0; element /= extents[dimension])
    subscripts = "[" + std::to_string(element % extents[dimension]) + "]" + subscripts;
  std::vector<std::string> const names = identifiers(members);
  for (std::size_t i = 0; i < members.size(); ++i) {
    std::size_t const count = number_count(members[i].extents, members[i].members);
    if (rest < count)
      return element_name(name + subscripts + "." + names[i], members[i].extents, members[i].members, rest);
    rest -= count;
  }
  return name + subscripts;
}

std::string element_name(std::string const &identifier, Object const &object, std::uint32_t element) {
  return element_name(identifier, object.extents, object.members, element);
}

} // namespace symreal
