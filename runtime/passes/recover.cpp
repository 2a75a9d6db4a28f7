#include "passes/pass.h"

namespace symreal {

// What `preprocess` has split stays as it is.
Graph pass_recover(Graph const &graph, PassSettings const &settings) {
  if (settings.mode != FloatingPoint::fast || !graph.precomputed.empty()) return graph;
  return algebra::recover_structure(graph, settings.effort);
}

} // namespace symreal
