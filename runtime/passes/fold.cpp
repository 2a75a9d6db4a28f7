#include "passes/pass.h"
#include "passes/sweep.h"

namespace symreal {

Graph pass_fold(Graph const &graph, FloatingPoint mode) { return sweep(graph, {.mode = mode, .fold = true}); }

} // namespace symreal
