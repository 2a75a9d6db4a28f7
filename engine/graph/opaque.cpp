#include "engine/graph/opaque.h"

#include <algorithm>
#include <cmath>

namespace symreal {

std::size_t table_index(double index, std::size_t extent) {
  if (!(index > 0)) return 0;
  return index < static_cast<double>(extent) ? static_cast<std::size_t>(index) : extent - 1;
}

double look_up(Table const &table, double row, double column) {
  std::size_t at = table_index(row, table.extents[0]);
  if (table.extents.size() == 2) at = at * table.extents[1] + table_index(column, table.extents[1]);
  return table.values[at];
}

std::vector<NodeId> arguments_of(Graph const &graph, NodeId list) {
  std::vector<NodeId> values;
  for (; graph.nodes[list].op == Op::argument; list = graph.nodes[list].operand[0])
    values.push_back(graph.nodes[list].operand[1]);
  std::reverse(values.begin(), values.end());
  return values;
}

namespace {

// Whether the node is a constant index below `end`.
bool is_number_below(Graph const &graph, NodeId id, std::size_t end) {
  Node const &node = graph.nodes[id];
  if (!node.is_constant()) return false;
  double const value = node.value();
  return value >= 0 && value < static_cast<double>(end) && value == std::floor(value);
}

bool is_structure(Graph const &graph, NodeId id) {
  Op const op = graph.nodes[id].op;
  return !is_leaf(op) && info(op).has(flag::STRUCTURE);
}

bool is_list(Graph const &graph, NodeId id) {
  Node const &node = graph.nodes[id];
  return node.op == Op::argument || (node.is_constant() && node.value() == 0);
}

char const *lookup_violation(Graph const &graph, Node const &node) {
  if (!is_number_below(graph, node.operand[0], graph.tables.size())) return "reads a table that does not exist";
  std::size_t const indices = node.op == Op::lookup ? 1 : 2;
  return graph.tables[table_of(graph, node)].extents.size() == indices ? nullptr
                                                                       : "has not as many indices as its table";
}

// Whether constant arguments are integers where the function takes integers.
bool fit(Graph const &graph, External const &external, std::vector<NodeId> const &arguments) {
  std::size_t next = 0;
  for (ExternalValue const &parameter : external.parameters) {
    if (!parameter.is_given()) continue;
    Node const &argument = graph.nodes[arguments[next]];
    if (parameter.kind == ExternalValue::Kind::integer && argument.is_constant()) {
      double const value = argument.value();
      if (value != std::trunc(value) || !(std::fabs(value) < 0x1p127)) return false;
    }
    next += parameter.count;
  }
  return true;
}

char const *call_violation(Graph const &graph, Node const &node) {
  if (!is_number_below(graph, node.operand[1], graph.externals.size())) return "calls a function that does not exist";
  if (!is_list(graph, node.operand[0])) return "has no list of arguments";
  External const &external = graph.externals[function_of(graph, node)];
  if (external.pure != (node.op == Op::call)) return "is not the kind of call that its function needs";
  std::vector<NodeId> const arguments = arguments_of(graph, node.operand[0]);
  if (arguments.size() != external.argument_count()) return "has not as many arguments as its function takes";
  if (!fit(graph, external, arguments)) return "hands over a number that its function's integer cannot be";
  if (node.op == Op::call) return nullptr;
  Node const &before = graph.nodes[node.operand[2]];
  bool const is_first = before.is_constant() && before.value() == 0;
  return is_first || before.op == Op::call_in_order ? nullptr : "follows something that is no call in order";
}

char const *returned_violation(Graph const &graph, Node const &node) {
  Node const &call = graph.nodes[node.operand[0]];
  if (!is_call(call.op)) return "is a result of something that is no call";
  std::size_t const results = graph.externals[function_of(graph, call)].result_count();
  return is_number_below(graph, node.operand[1], results) ? nullptr : "is a result that its function does not have";
}

} // namespace

char const *find_opaque_violation(Graph const &graph, NodeId id) {
  Node const &node = graph.nodes[id];
  char const *what = nullptr;
  std::size_t first_value = 0; // index of the first operand that must be a number
  switch (node.op) {
  case Op::lookup:
  case Op::lookup2: what = lookup_violation(graph, node); break;
  case Op::argument:
    if (!is_list(graph, node.operand[0])) what = "extends something that is no list of arguments";
    first_value = 1;
    break;
  case Op::call:
  case Op::call_in_order:
    what = call_violation(graph, node);
    first_value = arity(node.op);
    break;
  case Op::returned:
    what = returned_violation(graph, node);
    first_value = arity(node.op);
    break;
  default: break;
  }
  for (std::size_t i = first_value; i < arity(node.op); ++i)
    if (is_structure(graph, node.operand[i])) what = "computes with something that is no number";
  return what;
}

} // namespace symreal
