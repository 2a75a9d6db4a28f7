#include "engine/optimise/passes/pass.h"

#include "engine/graph/implicit.h"
#include "engine/graph/validate.h"

#include <algorithm>
#include <cstdio>

namespace symreal {

std::span<PassInfo const> pass_table() {
  static constexpr PassInfo table[] = {
#define PASS(name, by_default, mode, doc) {#name, pass_##name, by_default, FloatingPoint::mode, doc},
#include "engine/optimise/passes/passes.def"
#undef PASS
  };
  return table;
}

std::vector<std::string> default_passes() {
  std::vector<std::string> names;
  for (PassInfo const &pass : pass_table())
    if (pass.by_default) names.emplace_back(pass.name);
  return names;
}

PassInfo const &find_pass(std::string_view name) {
  auto table = pass_table();
  auto found = std::find_if(table.begin(), table.end(), [name](PassInfo const &pass) { return pass.name == name; });
  if (found == table.end()) fail(DiagnosticId::unknown_pass, {}, "no pass is named '" + std::string(name) + "'");
  return *found;
}

std::vector<std::string> parse_passes(std::string_view text) {
  std::vector<std::string> names;
  if (text == "none") return names;
  while (true) {
    std::size_t const comma = std::min(text.find(','), text.size());
    if (std::string_view const name = text.substr(0, comma); name == "default")
      std::ranges::move(default_passes(), std::back_inserter(names));
    else
      names.emplace_back(find_pass(name).name);
    if (comma == text.size()) return names;
    text.remove_prefix(comma + 1);
  }
}

Graph run_passes(Graph graph, std::span<std::string const> names, PassSettings const &settings) {
  graph = without_implicit(std::move(graph));
  for (std::string const &name : names) {
    PassInfo const &pass = find_pass(name);
    if (!pass.runs_in(settings.mode)) continue;
    graph = pass.run(std::move(graph), settings);
    if (std::string violation = find_violation(graph); !violation.empty()) {
      std::fprintf(stderr, "symreal: after pass %s: %s\n", name.c_str(), violation.c_str());
      internal_check(false && "a pass left the graph invalid");
    }
  }
  return graph;
}

} // namespace symreal
