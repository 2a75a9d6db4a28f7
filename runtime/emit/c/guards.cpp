#include "emit/c/parts.h"
#include "emit/language/words.h"

#include <fmt/format.h>

namespace symreal {

namespace {

// Two question marks could begin a trigraph.
std::string in_quotes(std::string const &text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '\n') c = ' ';
    if (c == '"' || c == '\\' || (c == '?' && result.back() == '?')) result += '\\';
    result += c;
  }
  return result + '"';
}

} // namespace

std::string c_guard_text(Emission const &emission) {
  Graph const &graph = emission.graph();
  if (graph.guards.empty()) return {};
  std::string list;
  for (Guard const &guard : graph.guards) list += "      " + in_quotes(guard_text(graph, guard)) + ",\n";
  return fmt::format("\nchar const *{}(int guard) {{\n  static char const *const text[] = {{\n{}  }};\n"
                     "  return guard > 0 && guard <= {} ? text[guard - 1] : \"\";\n}}\n",
                     emission.name("guard_text"), list, graph.guards.size());
}

} // namespace symreal
