#include "engine/optimise/passes/pass.h"
#include "engine/optimise/passes/sweep.h"

namespace symreal {

// Together rather than in turn: a folded constant makes an identity, an identity makes two nodes equal, equal nodes
// make x-x. As every node is made from operands in final form, one sweep reaches what any repetition of the four would.
Graph pass_simplify(Graph graph, PassSettings const &settings) {
  constexpr auto all = static_cast<unsigned>(Topic::identities) | static_cast<unsigned>(Topic::signs) |
                       static_cast<unsigned>(Topic::algebra);
  return sweep(graph,
               {.mode = settings.mode, .topics = all, .fold = true, .canonical_order = true, .limit = settings.limit});
}

} // namespace symreal
