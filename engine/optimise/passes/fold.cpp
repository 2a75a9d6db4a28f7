#include "engine/optimise/passes/pass.h"
#include "engine/optimise/passes/rule.h"

namespace symreal {

Graph pass_fold(Graph graph, PassSettings const &settings) {
  return sweep(graph, {.mode = settings.mode, .fold = true, .limit = settings.limit});
}

} // namespace symreal
