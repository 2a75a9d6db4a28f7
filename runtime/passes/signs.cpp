#include "passes/pass.h"
#include "passes/sweep.h"

namespace symreal {

Graph pass_signs(Graph const &graph, FloatingPoint mode) {
  return sweep(graph, {.mode = mode, .topics = static_cast<unsigned>(Topic::signs)});
}

} // namespace symreal
