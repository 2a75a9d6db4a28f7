#include "engine/plan/text/lines.h"

namespace symreal {

std::string_view Lines::next() {
  std::size_t const end = std::min(rest_.find('\n'), rest_.size());
  std::string_view const line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return line;
}

NodeNames::NodeNames(Graph const &graph) : graph_(graph) {
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (!graph.nodes[id].is_constant()) nodes_.push_back(id);
}

NodeId NodeNames::find(Line &line, std::string const &word) const {
  if (word[0] == '%') {
    std::optional<NodeId> const number = parse_natural(std::string_view(word).substr(1));
    if (!number || *number >= nodes_.size()) line.error("'" + word + "' is not a node of the graph");
    return nodes_[*number];
  }
  auto const number = parse_number(word);
  if (!number) line.error("'" + word + "' is neither a node nor a number");
  auto const found = std::ranges::find(graph_.nodes, Node::constant(*number));
  if (found == graph_.nodes.end()) line.error("the graph has no constant " + word);
  return static_cast<NodeId>(found - graph_.nodes.begin());
}

} // namespace symreal
