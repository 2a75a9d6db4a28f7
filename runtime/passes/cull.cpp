#include "passes/compact.h"
#include "passes/pass.h"

namespace symreal {

Graph pass_cull(Graph const &graph, PassSettings const &) { return compact(graph, live_nodes(graph)); }

} // namespace symreal
