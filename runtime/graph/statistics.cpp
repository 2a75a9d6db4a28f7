#include "graph/statistics.h"

namespace symreal {

Statistics statistics(Graph const &graph) {
  Statistics result;
  std::vector<char> live = live_nodes(graph);
  bool split = !graph.precomputed.empty();
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    ++result.recorded[node.op];
    if (!live[id]) continue;
    bool hoisted = split && node.attribute == Attribute::parametric;
    ++(hoisted ? result.preprocess : result.compute)[node.op];
  }
  return result;
}

} // namespace symreal
