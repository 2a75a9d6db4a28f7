// Opaque operations: those whose meaning depends on tables or functions of their graph.
#pragma once

#include "engine/graph/graph.h"

#include <span>

namespace symreal {

// Description of a violated invariant of an opaque node, or nullptr. Argument lists and calls may only be operands of
// the operations that they belong to.
char const *find_opaque_violation(Graph const &graph, NodeId id);

// Index into a table: truncated and clamped to the extent. A NaN counts as 0.
std::size_t table_index(double index, std::size_t extent);
double look_up(Table const &table, double row, double column);

// Values of an argument list, first to last.
std::vector<NodeId> arguments_of(Graph const &graph, NodeId list);
inline std::size_t function_of(Graph const &graph, Node const &call) {
  return static_cast<std::size_t>(graph.nodes[call.operand[1]].value());
}
// Table number of a lookup; result number of `returned`.
inline std::size_t table_of(Graph const &graph, Node const &lookup) {
  return static_cast<std::size_t>(graph.nodes[lookup.operand[0]].value());
}
inline std::size_t result_of(Graph const &graph, Node const &returned) {
  return static_cast<std::size_t>(graph.nodes[returned.operand[1]].value());
}

} // namespace symreal
