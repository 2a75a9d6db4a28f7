#include "engine/optimise/passes/pass.h"
#include "engine/optimise/passes/rule.h"

namespace symreal {

Graph pass_identities(Graph graph, PassSettings const &settings) {
  return sweep(graph,
               {.mode = settings.mode, .topics = static_cast<unsigned>(Topic::identities), .limit = settings.limit});
}

} // namespace symreal
