#include "passes/pass.h"
#include "passes/sweep.h"

namespace symreal {

Graph pass_identities(Graph graph, PassSettings const &settings) {
  return sweep(graph,
               {.mode = settings.mode, .topics = static_cast<unsigned>(Topic::identities), .limit = settings.limit});
}

} // namespace symreal
