#include "emit/print/variable_names.h"

#include "graph/names.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace symreal {

// Variables without a name, and the arrays of calls: t1, r1, s1, a1_2.
static bool is_numbered(std::string const &name) {
  auto const is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return name.size() > 1 && std::string_view("arst").find(name[0]) != std::string_view::npos && is_digit(name[1]) &&
         std::all_of(name.begin() + 2, name.end(), [&](char c) { return c == '_' || is_digit(c); });
}

// Names of the generated functions' own, besides keywords and the operations: arrays, the status, and words that some
// compilers predefine.
static bool is_taken(std::string const &name) {
  static std::set<std::string> const taken = [] {
    std::set<std::string> names = {"input",  "output", "constants", "parameters", "v",
                                   "failed", "unix",   "linux",     "i386"};
    for (OperationInfo const &operation : operations()) names.emplace(operation.c);
    return names;
  }();
  return is_numbered(name) || name.starts_with("table_") || is_keyword(name) || taken.contains(name);
}

VariableNames::VariableNames(Schedule const &plan, FunctionBody const &body) {
  Graph const &graph = *plan.graph;
  if (graph.node_name.empty()) return;
  std::set<std::string> all(graph.names.begin(), graph.names.end()), functions;
  for (External const &external : graph.externals) functions.insert(external.name);
  for (std::string const &name : graph.names) {
    std::string base = name;
    // C reserves what begins with an underscore; other letters than ASCII's are not C99.
    for (char &c : base)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    if (base[0] == '_') base = "u" + base;
    if (is_taken(base) || functions.contains(base) || (base != name && all.contains(base))) base += '_';
    while (base != name && !all.insert(base).second) base += '_';
    bases_.push_back(base);
  }
  std::vector<std::uint32_t> next(bases_.size(), 1);
  for (NodeId id : body.variables) {
    NameId const name = body.regions.is_gate(id) ? no_name : graph.node_name[id];
    entries_.push_back({name, 0});
    if (name == no_name) continue;
    std::uint32_t number = next[name];
    while (number > 1 && all.contains(bases_[name] + "_" + std::to_string(number))) ++number;
    entries_.back().number = number;
    next[name] = number + 1;
  }
}

std::string VariableNames::operator()(std::size_t variable) const {
  if (entries_.empty() || entries_[variable].name == no_name) return "t" + std::to_string(variable);
  Entry const &entry = entries_[variable];
  return entry.number == 1 ? bases_[entry.name] : bases_[entry.name] + "_" + std::to_string(entry.number);
}

} // namespace symreal
