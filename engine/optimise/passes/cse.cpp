#include "engine/optimise/passes/pass.h"
#include "engine/optimise/passes/rule.h"

namespace symreal {

Graph pass_cse(Graph graph, PassSettings const &settings) {
  return sweep(graph, {.mode = settings.mode, .canonical_order = true});
}

} // namespace symreal
