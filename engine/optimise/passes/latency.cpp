#include "engine/optimise/passes/balance.h"
#include "engine/optimise/passes/pass.h"

namespace symreal {

// Balances if the span bounds the run time. A processor that issues two operations per cycle and completes a sum or
// product in four cycles needs eight operations beside each one on the longest path; as it sees only a part of the
// program, the threshold is twice that. The loop search skips this pass, which would break the repetition.
Graph pass_latency(Graph graph, PassSettings const &settings) {
  constexpr double beside_each = 16;
  if (!settings.searches) return graph;
  bool const waits = span(graph, settings.costs) * beside_each > algebra::cost_of(graph, settings.costs);
  return waits ? pass_balance(std::move(graph), settings) : graph;
}

} // namespace symreal
