#include "tool/fmu/unit_variables.h"

#include "engine/graph/names.h"
#include "engine/graph/states.h"

#include <set>

namespace symreal::tool {

namespace {

using Role = UnitVariable::Role;

void append(std::vector<Object> &all, std::vector<Object> const &objects) {
  all.insert(all.end(), objects.begin(), objects.end());
}

// Names of all objects, made in one list so that they are unique.
std::vector<std::string> names_of(Graph const &graph) {
  std::vector<Object> all = {{.label = "time", .extents = {}}};
  append(all, graph.inputs);
  append(all, graph.parameters);
  append(all, graph.outputs);
  return element_names(all);
}

// Indices of the inputs and parameters that a result depends on.
std::vector<std::size_t> dependencies(Graph const &graph, NodeId result) {
  std::vector<char> seen(graph.nodes.size(), 0);
  std::vector<NodeId> found = {result};
  std::set<std::size_t> leaves;
  seen[result] = 1;
  while (!found.empty()) {
    Node const &node = graph.nodes[found.back()];
    found.pop_back();
    if (node.op == Op::input) leaves.insert(1 + node.slot());
    if (node.op == Op::parameter) leaves.insert(1 + graph.input_count() + node.slot());
    if (is_leaf(node.op)) continue;
    for (NodeId const operand : node.operand)
      if (operand != no_node && !seen[operand]) {
        seen[operand] = 1;
        found.push_back(operand);
      }
  }
  return {leaves.begin(), leaves.end()};
}

} // namespace

std::vector<UnitVariable> unit_variables(Graph const &graph) {
  std::vector<UnitVariable> variables;
  for (std::string const &name : names_of(graph)) variables.push_back({.name = name, .dependencies = {}});
  std::size_t const parameters = 1 + graph.input_count(), outputs = parameters + graph.parameter_count();
  for (std::size_t k = 0; k < graph.input_count(); ++k) {
    variables[1 + k].role = Role::input;
    variables[1 + k].start = graph.input_values[k];
  }
  for (std::size_t k = 0; k < graph.parameter_count(); ++k) {
    variables[parameters + k].role = Role::parameter;
    variables[parameters + k].start = graph.parameter_values[k];
  }
  for (std::size_t k = 0; k < graph.output_count(); ++k) {
    variables[outputs + k].role = Role::output;
    variables[outputs + k].dependencies = dependencies(graph, graph.results[k]);
  }
  for (State const &state : find_states(graph)) {
    Object const &input = graph.inputs[state.input], &output = graph.outputs[state.output];
    for (std::uint32_t k = 0; k < input.count; ++k) {
      variables[1 + input.first + k].role = Role::state;
      variables[1 + input.first + k].dependencies = {1 + input.first + k};
      variables[outputs + output.first + k].role = Role::derivative;
      variables[outputs + output.first + k].state = 1 + input.first + k;
    }
  }
  return variables;
}

} // namespace symreal::tool
