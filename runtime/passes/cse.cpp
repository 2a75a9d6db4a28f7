#include "passes/pass.h"
#include "passes/sweep.h"

namespace symreal {

Graph pass_cse(Graph const &graph, FloatingPoint mode) { return sweep(graph, {.mode = mode, .canonical_order = true}); }

} // namespace symreal
