#include "engine/optimise/passes/pass.h"
#include "engine/optimise/passes/rule.h"

namespace symreal {

// All topics in one sweep: a folded constant enables an identity, an identity makes two nodes equal, equal nodes make
// x-x. As every node is built from operands in final form, one sweep reaches the fixed point.
Graph pass_simplify(Graph graph, PassSettings const &settings) {
  constexpr auto all = static_cast<unsigned>(Topic::identities) | static_cast<unsigned>(Topic::signs) |
                       static_cast<unsigned>(Topic::algebra);
  return sweep(graph,
               {.mode = settings.mode, .topics = all, .fold = true, .canonical_order = true, .limit = settings.limit});
}

} // namespace symreal
