// What generated code says of its guards: a list in the header, a function that gives the text of one.
#include "emit/c/parts.h"

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

std::string c_guard_list(Schedule const &plan, EmitOptions const &options) {
  Graph const &graph = *plan.graph;
  std::string out =
      "/* compute returns 0, or the number of the first guard that does not hold; output is left untouched "
      "then.\n   The code is right where the original decides as it did while it was recorded:\n";
  for (std::size_t k = 0; k < graph.guards.size(); ++k)
    out += fmt::format("   {:>3}  {}\n", k + 1, in_comment(guard_text(graph, graph.guards[k])));
  return out + fmt::format("*/\nenum {{ {} = {} }};\n/* The condition of a guard and its places in the source. */\n"
                           "char const *{}(int guard);\n\n",
                           prefixed(options, "guard_count"), graph.guards.size(), prefixed(options, "guard_text"));
}

std::string c_guard_text(Schedule const &plan, EmitOptions const &options) {
  Graph const &graph = *plan.graph;
  std::string list;
  for (Guard const &guard : graph.guards) list += "      " + in_quotes(guard_text(graph, guard)) + ",\n";
  return fmt::format("char const *{}(int guard) {{\n  static char const *const text[] = {{\n{}  }};\n"
                     "  return guard > 0 && guard <= {} ? text[guard - 1] : \"\";\n}}\n",
                     prefixed(options, "guard_text"), list, graph.guards.size());
}

} // namespace symreal
