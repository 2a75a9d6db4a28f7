#include "engine/optimise/passes/pass.h"

namespace symreal {

// Runs before all other passes, since a dead node may prove two live ones equal. A graph that `preprocess` has split
// stays unchanged.
Graph pass_recover(Graph graph, PassSettings const &settings) {
  if (settings.effort == 0 || !graph.precomputed.empty()) return graph;
  return algebra::recover_structure(pass_simplify(std::move(graph), settings), settings.effort, settings.costs,
                                    settings.tell, settings.searches);
}

} // namespace symreal
