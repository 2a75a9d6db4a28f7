#include "schedule/program.h"

#include <algorithm>

namespace symreal {

namespace {

// Expressions nest only so far: deeper ones are hard to read, and compilers bound what they parse.
constexpr unsigned most_nested_operations = 12, most_nested_depth = 6;

struct Reach {
  std::vector<char> needed;
  std::vector<std::uint32_t> uses;
};

// What the roots need. The walk stops at nodes that are read from `constants`.
Reach reach(Graph const &graph, std::vector<NodeId> const &roots, std::vector<std::uint32_t> const *constant_slot) {
  Reach result{std::vector<char>(graph.nodes.size(), 0), std::vector<std::uint32_t>(graph.nodes.size(), 0)};
  for (NodeId root : roots) {
    result.needed[root] = 1;
    ++result.uses[root];
  }
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!result.needed[id] || is_leaf(node.op)) continue;
    if (constant_slot && (*constant_slot)[id] != no_slot) continue;
    for (NodeId operand : node.operand) {
      if (operand == no_node) continue;
      result.needed[operand] = 1;
      ++result.uses[operand];
    }
  }
  return result;
}

// Statements stand in the order of their nodes, and a condition is younger than what it is computed from.
void place_checks(FunctionBody &body, std::vector<NodeId> const &conditions) {
  std::size_t before = 0;
  for (NodeId condition : conditions) {
    while (before < body.variables.size() && body.variables[before] <= condition) ++before;
    body.checks.push_back({condition, before});
  }
}

// All inputs are read before an output is written, since the arrays may overlap; so what an output holds
// must be in a variable by then.
FunctionBody lay_out(Graph const &graph, std::vector<NodeId> const &results, Nesting nesting,
                     std::vector<NodeId> const &conditions, std::vector<std::uint32_t> const *constant_slot) {
  std::vector<NodeId> roots = results;
  roots.insert(roots.end(), conditions.begin(), conditions.end());
  Reach const needs = reach(graph, roots, constant_slot);
  std::vector<char> is_result(graph.nodes.size(), 0);
  for (NodeId result : results) is_result[result] = 1;
  std::vector<std::uint8_t> operations(graph.nodes.size(), 0), depth(graph.nodes.size(), 0); // of nested expressions
  FunctionBody body;
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!needs.needed[id]) continue;
    bool is_read = is_leaf(node.op) || (constant_slot && (*constant_slot)[id] != no_slot);
    unsigned size = 1, height = 0;
    if (!is_read)
      for (NodeId operand : node.operand) {
        if (operand == no_node) continue;
        size += operations[operand];
        height = std::max<unsigned>(height, depth[operand]);
      }
    bool nests = is_read || (nesting == Nesting::bounded && needs.uses[id] == 1 && size <= most_nested_operations &&
                             height < most_nested_depth);
    if (is_result[id] && !node.is_constant()) nests = false;
    if (!nests)
      body.variables.push_back(static_cast<NodeId>(id));
    else if (!is_read) {
      operations[id] = static_cast<std::uint8_t>(size);
      depth[id] = static_cast<std::uint8_t>(height + 1);
    }
  }
  body.results = results;
  place_checks(body, conditions);
  return body;
}

} // namespace

Program schedule(Graph const &graph, Nesting nesting) {
  Program program{&graph, {}, {}, std::vector<std::uint32_t>(graph.nodes.size(), no_slot), 0};
  std::vector<NodeId> stored = graph.precomputed;
  for (std::size_t slot = 0; slot < stored.size(); ++slot)
    program.constant_slot[stored[slot]] = static_cast<std::uint32_t>(slot);
  // Without pass preprocess `compute` still sees no parameters: those that it needs are handed through `constants`.
  std::vector<NodeId> conditions, roots = graph.results;
  for (Guard const &guard : graph.guards) conditions.push_back(guard.condition);
  roots.insert(roots.end(), conditions.begin(), conditions.end());
  Reach const needs = reach(graph, roots, &program.constant_slot);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (needs.needed[id] && graph.nodes[id].op == Op::parameter && program.constant_slot[id] == no_slot) {
      program.constant_slot[id] = static_cast<std::uint32_t>(stored.size());
      stored.push_back(static_cast<NodeId>(id));
    }
  program.constant_count = stored.size();
  program.preprocess = lay_out(graph, stored, nesting, {}, nullptr);
  program.compute = lay_out(graph, graph.results, nesting, conditions, &program.constant_slot);
  return program;
}

} // namespace symreal
