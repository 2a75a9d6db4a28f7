#include "passes/pass.h"
#include "passes/sweep.h"

namespace symreal {

Graph pass_signs(Graph graph, PassSettings const &settings) {
  return sweep(graph, {.mode = settings.mode, .topics = static_cast<unsigned>(Topic::signs), .limit = settings.limit});
}

} // namespace symreal
