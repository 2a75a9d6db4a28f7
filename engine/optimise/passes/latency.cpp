#include "engine/optimise/passes/balance.h"
#include "engine/optimise/passes/pass.h"

namespace symreal {

// A processor that begins two operations in a cycle and has the result of a sum or product after four of them has
// little to do where less than eight operations stand beside each one of the longest path. It sees a part of the
// program only, so that twice as many are needed. Where loops are looked for, what is alike stays alike.
Graph pass_latency(Graph graph, PassSettings const &settings) {
  constexpr double beside_each = 16;
  if (!settings.searches) return graph;
  bool const waits = span(graph, settings.costs) * beside_each > work(graph, settings.costs);
  return waits ? pass_balance(std::move(graph), settings) : graph;
}

} // namespace symreal
