#include "engine/graph/names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>

namespace symreal {

static constexpr auto c_keywords = std::to_array<std::string_view>({
    "alignas",   "alignof",   "and",           "and_eq",       "asm",
    "auto",      "bitand",    "bitor",         "bool",         "break",
    "case",      "catch",     "char",          "char16_t",     "char32_t",
    "char8_t",   "class",     "co_await",      "co_return",    "co_yield",
    "compl",     "concept",   "const",         "const_cast",   "consteval",
    "constexpr", "constinit", "continue",      "decltype",     "default",
    "delete",    "do",        "double",        "dynamic_cast", "else",
    "enum",      "explicit",  "export",        "extern",       "false",
    "float",     "for",       "friend",        "goto",         "i386",
    "if",        "inline",    "int",           "linux",        "long",
    "mutable",   "namespace", "new",           "noexcept",     "not",
    "not_eq",    "nullptr",   "operator",      "or",           "or_eq",
    "private",   "protected", "public",        "register",     "reinterpret_cast",
    "requires",  "restrict",  "return",        "short",        "signed",
    "sizeof",    "static",    "static_assert", "static_cast",  "struct",
    "switch",    "template",  "this",          "thread_local", "throw",
    "true",      "try",       "typedef",       "typeid",       "typename",
    "typeof",    "union",     "unix",          "unsigned",     "using",
    "virtual",   "void",      "volatile",      "wchar_t",      "while",
    "xor",       "xor_eq",
});
static_assert(std::ranges::is_sorted(c_keywords));
constinit NameRules const c_names = {c_keywords};

std::string NameRules::key(std::string_view name) const {
  std::string key(name);
  if (ignores_case)
    for (char &c : key) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return key;
}

std::string NameRules::spelled(std::string_view name) const {
  if (has_underscores) return std::string(name);
  std::string text;
  bool capital = false;
  for (char c : name) {
    auto const letter = static_cast<unsigned char>(c);
    if (c != '_') text += static_cast<char>(text.empty() ? std::tolower(letter) : capital ? std::toupper(letter) : c);
    capital = c == '_';
  }
  return text;
}

bool is_identifier(std::string_view name) {
  auto const is_part = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '_'); };
  return !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) && std::ranges::all_of(name, is_part);
}

// Whether C and C++ reserve the name for the implementation.
static bool is_reserved(std::string_view name) {
  return name.size() > 1 && name[0] == '_' && (name[1] == '_' || std::isupper(static_cast<unsigned char>(name[1])));
}

bool NameRules::is_keyword(std::string_view word) const { return std::ranges::binary_search(keywords, key(word)); }

std::string identifier(std::string const &label, NameRules const &rules) {
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
  if (!is_identifier(name) || is_reserved(name) || rules.is_keyword(name)) name = "value_" + name;
  while (name.back() == '_') name.pop_back();
  return name;
}

// Appends numbers to make the names distinct.
static std::vector<std::string> numbered(std::vector<std::string> names, NameRules const &rules) {
  std::set<std::string> taken;
  for (std::string &name : names) {
    std::string const base = name;
    for (int copy = 2; !taken.insert(rules.key(name)).second; ++copy) name = base + "_" + std::to_string(copy);
  }
  return names;
}

std::vector<std::string> identifiers(std::vector<Object> const &objects, NameRules const &rules) {
  // Interface suffixes of "input_" and "output_".
  static constexpr std::array<std::string_view, 3> own = {"count", "type", "values"};
  std::vector<std::string> names;
  for (Object const &object : objects) {
    std::string const name = identifier(object.label, rules);
    bool const is_own =
        std::ranges::any_of(own, [&](std::string_view word) { return rules.key(name) == rules.key(word); });
    names.push_back(is_own ? "value_" + name : name);
  }
  return numbered(std::move(names), rules);
}

std::vector<std::string> identifiers(std::vector<Member> const &members, NameRules const &rules) {
  std::vector<std::string> names;
  for (Member const &member : members) {
    bool const is_plain = is_identifier(member.name) && !is_reserved(member.name) && !rules.is_keyword(member.name);
    names.push_back(is_plain ? member.name : identifier(member.name, rules));
  }
  return numbered(std::move(names), rules);
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

std::vector<std::string> element_names(std::vector<Object> const &objects, NameRules const &rules) {
  std::vector<std::string> const names = identifiers(objects, rules);
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < objects.size(); ++i)
    for (std::uint32_t element = 0; element < objects[i].count; ++element)
      elements.push_back(element_name(names[i], objects[i], element));
  return elements;
}

std::optional<std::string> element_name(std::vector<Object> const &objects, std::uint32_t slot) {
  std::vector<std::string> const names = identifiers(objects);
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (slot - objects[i].first < objects[i].count) return element_name(names[i], objects[i], slot - objects[i].first);
  return std::nullopt;
}

} // namespace symreal
