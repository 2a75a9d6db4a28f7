#include "engine/optimise/passes/groups.h"
#include "engine/optimise/passes/pass.h"

namespace symreal {

// The terms of a sum, and the factors of a product, that depend on parameters or numbers alone are brought together:
// a + x + b is x + (a + b), whose second sum `preprocess` computes. What comes from inputs stays in its order.
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
