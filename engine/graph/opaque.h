// The operations that are no functions of their operands alone: what they refer to in their graph.
#pragma once

#include "engine/graph/graph.h"

#include <span>

namespace symreal {

// The invariant of an opaque node, and of its neighbours: a list of arguments and a call stand only where they belong.
// The violation in words, or nullptr.
char const *find_opaque_violation(Graph const &graph, NodeId id);

// An index of a table: truncated, and moved into the extent. Not a number counts as 0.
std::size_t table_index(double index, std::size_t extent);
double look_up(Table const &table, double row, double column);

// The values in a list of arguments, first to last.
std::vector<NodeId> arguments_of(Graph const &graph, NodeId list);
inline std::size_t function_of(Graph const &graph, Node const &call) {
  return static_cast<std::size_t>(graph.nodes[call.operand[1]].value());
}
// Of a lookup, the number of its table; of `returned`, which result.
inline std::size_t table_of(Graph const &graph, Node const &lookup) {
  return static_cast<std::size_t>(graph.nodes[lookup.operand[0]].value());
}
inline std::size_t result_of(Graph const &graph, Node const &returned) {
  return static_cast<std::size_t>(graph.nodes[returned.operand[1]].value());
}

} // namespace symreal
