#include "engine/optimise/passes/pass.h"

namespace symreal {

Graph pass_cull(Graph graph, PassSettings const &) {
  keep_nodes(graph, live_nodes(graph));
  return graph;
}

} // namespace symreal
