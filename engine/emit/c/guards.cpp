#include "engine/emit/c/parts.h"
#include "engine/emit/language/words.h"

#include <fmt/format.h>

namespace symreal {

// A C string literal; escapes successive question marks, which could begin a trigraph.
std::string c_string(std::string_view text) {
  std::string result = "\"";
  for (char const c : printable(text)) {
    if (c == '"' || c == '\\' || (c == '?' && result.back() == '?')) result += '\\';
    result += c;
  }
  return result + '"';
}

std::string c_guard_text(Emission const &emission) {
  Graph const &graph = emission.graph();
  if (graph.guards.empty()) return {};
  std::string list;
  for (Guard const &guard : graph.guards) list += "      " + c_string(guard_text(graph, guard)) + ",\n";
  return fmt::format("\nchar const *{}(int guard) {{\n  static char const *const text[] = {{\n{}  }};\n"
                     "  return guard > 0 && guard <= {} ? text[guard - 1] : \"\";\n}}\n",
                     emission.name("guard_text"), list, graph.guards.size());
}

} // namespace symreal
