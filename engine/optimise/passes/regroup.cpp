#include "engine/optimise/passes/groups.h"
#include "engine/optimise/passes/pass.h"

namespace symreal {

// Brings together the terms of a sum, or factors of a product, that depend on no input: a + x + b becomes x + (a + b),
// whose second sum `preprocess` computes. The other terms keep their order.
Graph pass_regroup(Graph graph, PassSettings const & /*settings*/) {
  if (!graph.precomputed.empty()) return graph;
  return regrouped(graph, [](Group const &group, NodeTable &table) -> std::optional<SignedNode> {
    std::optional<SignedNode> free, variable;
    std::size_t free_terms = 0;
    for (SignedNode const &term : group.terms) {
      bool const is_free = table[term.node].attribute != Attribute::variable;
      free_terms += is_free;
      std::optional<SignedNode> &part = is_free ? free : variable;
      part = part ? combined(group.op, *part, term, table) : term;
    }
    if (free_terms < 2 || !variable) return std::nullopt;
    return combined(group.op, *variable, *free, table);
  });
}

} // namespace symreal
