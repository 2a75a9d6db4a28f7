#include "engine/optimise/passes/pass.h"

namespace symreal {

// Runs before all others, since what no output needs may show that two things are equal which one needs. What
// `preprocess` has split stays as it is.
Graph pass_recover(Graph graph, PassSettings const &settings) {
  if (settings.effort == 0 || !graph.precomputed.empty()) return graph;
  return algebra::recover_structure(pass_simplify(std::move(graph), settings), settings.effort, settings.costs,
                                    settings.tell, settings.searches);
}

} // namespace symreal
