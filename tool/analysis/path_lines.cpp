#include "tool/analysis/path_lines.h"

#include <fmt/format.h>
#include <fstream>

namespace symreal::tool {

std::vector<PathLine> path_lines(Graph const &graph, std::vector<PathStep> const &path) {
  std::vector<PathLine> lines;
  NodeId last = no_node;
  for (PathStep const &step : path) {
    Place const place = place_of(graph, step.node);
    // Without places, runs of one operation form an entry.
    bool const is_other = place.file.empty() && last != no_node && graph.nodes[last].op != graph.nodes[step.node].op;
    last = step.node;
    if (lines.empty() || lines.back().place.file != place.file || lines.back().place.line != place.line || is_other) {
      lines.emplace_back();
      lines.back().place = place;
      lines.back().start = step.start;
    }
    PathLine &line = lines.back();
    if (step.node < graph.node_name.size() && graph.node_name[step.node] != no_name)
      line.name = graph.names[graph.node_name[step.node]];
    line.duration += step.duration;
    ++line.operations[graph.nodes[step.node].op];
    ++line.count;
  }
  return lines;
}

std::string to_string(OperationCounts const &counts) {
  std::string text;
  for (OperationInfo const &row : operations())
    if (std::size_t const count = counts[row.op])
      text += (text.empty() ? "" : ", ") + (count == 1 ? "" : std::to_string(count) + " ") + std::string(row.name);
  return text;
}

std::string source_text(Place const &place) {
  constexpr std::size_t longest = 80;
  std::ifstream file(place.file);
  std::string text;
  for (unsigned line = 0; line < place.line; ++line)
    if (!std::getline(file, text)) return {};
  std::size_t const first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t\r");
  if (first == text.npos) return {};
  text = text.substr(first, last + 1 - first);
  return text.size() > longest ? text.substr(0, longest) + " ..." : text;
}

} // namespace symreal::tool
