#include "emit/origins/value_checks.h"

#include "emit/origins/origins.h"

#include <fmt/format.h>

namespace symreal {

std::string value_check_helper() {
  return "#include <stdio.h>\n\n"
         "static int all_finite;\n\n"
         "static void report_value(double value, char const *what) {\n"
         "  if (all_finite) fprintf(stderr, \"not finite: %s is %g\\n\", what, value);\n"
         "  all_finite = 0;\n"
         "}\n";
}

std::string value_check_begin() { return "  all_finite = 1;\n"; }

std::string value_check(Graph const &graph, std::string const &variable, NodeId node) {
  std::string what = variable;
  if (!is_leaf(graph.nodes[node].op)) what += " = " + std::string(info(graph.nodes[node].op).name);
  if (!graph.node_location.empty() && graph.node_location[node] != no_location)
    if (std::string place = describe_locations(graph, {graph.node_location[node]}); !place.empty())
      what += " at " + place;
  std::string quoted;
  for (char c : what) quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return fmt::format("  if (!isfinite({0})) report_value({0}, \"{1}\");\n", variable, quoted);
}

} // namespace symreal
