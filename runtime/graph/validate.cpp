#include "graph/validate.h"

#include "graph/implicit.h"
#include "graph/opaque.h"

#include <algorithm>

namespace symreal {

static std::string check_objects(std::vector<Object> const &objects) {
  std::uint32_t next = 0;
  for (Object const &object : objects) {
    if (object.first != next || object.count != number_count(object.extents, object.members))
      return "object '" + object.label + "' does not fit its slots";
    next += object.count;
  }
  return {};
}

// Operations that the general check looks at more closely, also from their users.
static constexpr unsigned demanding = flag::WIDE | flag::TAKES_WIDE | flag::STRUCTURE | flag::OPAQUE;

// Most nodes of most graphs: a sum, a difference, a product or a quotient of two numbers.
static bool is_sound_arithmetic(Nodes const &nodes, NodeId id) {
  static constexpr auto plain = [] { // operations without a demand of their own, and leaves
    std::array<bool, static_cast<std::size_t>(Op::count)> result{};
    result.fill(true);
    for (OperationInfo const &row : detail::operation_table)
      result[static_cast<std::size_t>(row.op)] = !row.has(demanding);
    return result;
  }();
  Node const &node = nodes[id];
  if (node.op != Op::add && node.op != Op::sub && node.op != Op::mul && node.op != Op::div) return false;
  auto const [a, b, none] = node.operand;
  if (a >= id || b >= id || none != no_node) return false;
  return plain[static_cast<std::size_t>(nodes[a].op)] && plain[static_cast<std::size_t>(nodes[b].op)] &&
         node.attribute == std::max(nodes[a].attribute, nodes[b].attribute);
}

static std::string check_matrix(DerivativeMatrix const &matrix, std::vector<Object> const &outputs) {
  if (matrix.output >= outputs.size()) return "a matrix names an output that does not exist";
  std::size_t const whole = std::size_t{matrix.rows} * matrix.columns, count = matrix.row.size();
  if (matrix.column.size() != count || outputs[matrix.output].count != (matrix.is_packed ? count : whole))
    return "a matrix does not fit its output";
  for (std::size_t k = 0; k < count; ++k) {
    if (matrix.row[k] >= matrix.rows || matrix.column[k] >= matrix.columns) return "a matrix has no such row or column";
    if (k > 0 && std::pair(matrix.row[k - 1], matrix.column[k - 1]) >= std::pair(matrix.row[k], matrix.column[k]))
      return "the elements of a matrix do not stand row by row";
  }
  return {};
}

// The violation in words, or nullptr.
static char const *find_node_violation(Graph const &graph, NodeId id) {
  if (is_sound_arithmetic(graph.nodes, id)) return nullptr;
  Node const &node = graph.nodes[id];
  if (node.op >= Op::count) return "has no operation";
  if (node.op == Op::input) return node.slot() < graph.input_count() ? nullptr : "names an input that does not exist";
  if (node.op == Op::parameter)
    return node.slot() < graph.parameter_count() ? nullptr : "names a parameter that does not exist";
  if (is_leaf(node.op)) return nullptr;
  OperationInfo const &operation = info(node.op);
  Attribute attribute = Attribute::constant;
  unsigned flags = operation.flags; // and those of the operands
  for (std::size_t i = 0; i < node.operand.size(); ++i) {
    if ((i < operation.arity) != (node.operand[i] != no_node)) return "has the wrong number of operands";
    if (i >= operation.arity) continue;
    if (node.operand[i] >= id) return "is older than its operand";
    Node const &operand = graph.nodes[node.operand[i]];
    if (!is_leaf(operand.op)) flags |= info(operand.op).flags;
    attribute = std::max(attribute, operand.attribute);
  }
  if (node.attribute != attribute_of(node.op, attribute)) return "has the wrong attribute";
  if (!(flags & demanding)) return nullptr;
  for (std::size_t i = 0; i < operation.arity; ++i)
    if (is_wide(graph.nodes[node.operand[i]].op) != takes_wide(node.op, i))
      return takes_wide(node.op, i) ? "takes integers of 64 bits" : "takes no integers of 64 bits";
  return find_opaque_violation(graph, id);
}

std::string find_violation(Graph const &graph) {
  for (auto const *objects : {&graph.inputs, &graph.parameters, &graph.outputs})
    if (std::string violation = check_objects(*objects); !violation.empty()) return violation;
  for (DerivativeMatrix const &matrix : graph.matrices)
    if (std::string violation = check_matrix(matrix, graph.outputs); !violation.empty()) return violation;
  for (External const &external : graph.externals)
    if (is_implicit(external) && !is_well_formed_implicit(external)) return "'implicit function' has another form";
  if (graph.results.size() != graph.output_count()) return "the number of results differs from the outputs' size";
  if (graph.input_values.size() != graph.input_count()) return "the number of input values differs";
  if (graph.parameter_values.size() != graph.parameter_count()) return "the number of parameter values differs";
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (char const *violation = find_node_violation(graph, static_cast<NodeId>(id)))
      return "node " + std::to_string(id) + " " + violation;
  for (auto const *roots : {&graph.results, &graph.precomputed})
    for (NodeId root : *roots)
      if (root >= graph.nodes.size()) return "a result names a node that does not exist";
  for (NodeId result : graph.results)
    if (is_wide(graph.nodes[result].op)) return "a result is no number";
  for (Guard const &guard : graph.guards) {
    if (guard.condition >= graph.nodes.size()) return "a guard names a node that does not exist";
    if (is_wide(graph.nodes[guard.condition].op)) return "a guard's condition is no number";
    if (guard.location != no_location && guard.location >= graph.locations.size())
      return "a guard names a location that does not exist";
  }
  if (graph.last_effect != no_node &&
      (graph.last_effect >= graph.nodes.size() || graph.nodes[graph.last_effect].op != Op::call_in_order))
    return "the last effect is no call in order";
  if (!graph.node_location.empty() && graph.node_location.size() != graph.nodes.size())
    return "the number of nodes' locations differs";
  for (LocationId location : graph.node_location)
    if (location != no_location && location >= graph.locations.size())
      return "a node names a location that does not exist";
  if (!graph.node_name.empty() && graph.node_name.size() != graph.nodes.size())
    return "the number of nodes' names differs";
  if (!graph.node_exact.empty() && graph.node_exact.size() != graph.nodes.size())
    return "the number of nodes that may be exact differs";
  for (NodeId stored : graph.precomputed)
    if (graph.nodes[stored].attribute != Attribute::parametric) return "a precomputed node is not parametric";
  return {};
}

} // namespace symreal
