#include "engine/optimise/differentiate/calls.h"

#include "engine/graph/opaque.h"

#include <algorithm>

namespace symreal {

namespace {

bool is_same(External const &a, External const &b) {
  return a.name == b.name && a.returned == b.returned && a.parameters == b.parameters && a.derivatives == b.derivatives;
}

External const &called(Graph const &graph, NodeId id) {
  return graph.externals[function_of(graph, graph.nodes[graph.nodes[id].operand[0]])];
}

} // namespace

void add_derivative_functions(Graph &graph) {
  for (std::size_t k = 0; k < graph.externals.size(); ++k)
    if (derivative_function(graph, k) == graph.externals.size())
      if (std::optional<External> derivative = graph.externals[k].derivative())
        graph.externals.push_back(std::move(*derivative));
}

std::size_t derivative_function(Graph const &graph, std::size_t function) {
  std::optional<External> const wanted = graph.externals[function].derivative();
  if (!wanted) return graph.externals.size();
  auto const found = std::ranges::find_if(graph.externals, [&](External const &one) { return is_same(one, *wanted); });
  return static_cast<std::size_t>(found - graph.externals.begin());
}

std::vector<NodeId> differentiable_arguments(Graph const &graph, NodeId id) {
  if (graph.nodes[id].op != Op::returned) return {};
  External const &external = called(graph, id);
  if (external.derivatives.empty()) return {};
  std::vector<NodeId> const all = arguments_of(graph, graph.nodes[graph.nodes[id].operand[0]].operand[0]);
  std::vector<NodeId> numbers;
  for (std::size_t const argument : external.number_arguments()) numbers.push_back(all[argument]);
  return numbers;
}

std::size_t first_partial(Graph const &graph, NodeId id) {
  return result_of(graph, graph.nodes[id]) * called(graph, id).number_arguments().size();
}

} // namespace symreal
