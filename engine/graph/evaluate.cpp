#include "engine/graph/evaluate.h"

#include "engine/graph/implicit.h"

#include <symreal/integer_functions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace symreal {

namespace {

// Values of opaque nodes, computed in node order.
class OpaqueValues {
public:
  OpaqueValues(Graph const &graph, CallExternal const &call) : graph_(graph), results_(graph, call) {}

  double operator()(NodeId id, std::span<double const> values) {
    Node const &node = graph_.nodes[id];
    switch (node.op) {
    case Op::lookup: return look_up(graph_.tables[table_of(graph_, node)], values[node.operand[1]], 0);
    case Op::lookup2:
      return look_up(graph_.tables[table_of(graph_, node)], values[node.operand[1]], values[node.operand[2]]);
    case Op::returned: return results_of(node.operand[0], values)[result_of(graph_, node)];
    case Op::call:
    case Op::call_in_order: results_of(id, values); return 0;
    default: return 0;
    }
  }

private:
  std::vector<double> const &results_of(NodeId call, std::span<double const> values) {
    return results_.of(call, function_of(graph_, graph_.nodes[call]),
                       [&](NodeId argument) { return values[argument]; });
  }

  Graph const &graph_;
  CallResults results_;
};

// Infinite constants of the program stand for "none yet" or "no limit". Premise P1 of mode finite covers computed
// values only; such a constant may be compared, selected, and passed on: by hands_on, comparisons, and argument lists.
bool takes_infinity(Op op) {
  return hands_on(op) || op == Op::argument || (info(op).has(flag::BOOLEAN) && !info(op).has(flag::LOGICAL));
}

} // namespace

std::vector<double> CallResults::called(std::size_t function, std::vector<double> const &arguments) const {
  External const &external = graph_.externals[function];
  if (is_implicit(external)) return {arguments.begin(), arguments.begin() + external.parameters[2].count};
  std::vector<double> results(external.result_count());
  if (std::optional<ComplexFunction> const known = find_complex_function(external)) {
    evaluate(*known, arguments, results);
    return results;
  }
  internal_check(static_cast<bool>(call_));
  call_(function, arguments, results);
  return results;
}

bool calls_program(Graph const &graph) {
  return std::ranges::any_of(graph.externals, [](External const &external) {
    return !find_complex_function(external) && !is_implicit(external);
  });
}

double rounded(double value, Rounding rounding) {
  if (rounding == Rounding::none) return value;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  auto const nearest = static_cast<float>(value);
  if (rounding == Rounding::up_to_single && nearest < value) return std::nextafter(nearest, infinity);
  if (rounding == Rounding::down_to_single && nearest > value) return std::nextafter(nearest, -infinity);
  return nearest;
}

std::vector<double> evaluate(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters,
                             CallExternal const &call, Rounding rounding) {
  std::vector<double> values;
  values.reserve(graph.nodes.size());
  OpaqueValues opaque(graph, call);
  auto operand = [&](NodeId id) { return id == no_node ? 0.0 : values[id]; };
  for (Node const &node : graph.nodes) {
    switch (node.op) {
    case Op::constant: values.push_back(node.value()); break;
    case Op::input: values.push_back(inputs[node.slot()]); break;
    case Op::parameter: values.push_back(parameters[node.slot()]); break;
    default:
      if (info(node.op).has(flag::OPAQUE)) {
        values.push_back(opaque(static_cast<NodeId>(values.size()), values));
        break;
      }
      values.push_back(evaluate(node.op, operand(node.operand[0]), operand(node.operand[1]), operand(node.operand[2])));
    }
    if (!is_wide(node.op)) values.back() = rounded(values.back(), rounding);
  }
  return values;
}

std::size_t first_failing_guard(Graph const &graph, std::span<double const> values) {
  for (std::size_t k = 0; k < graph.guards.size(); ++k)
    if (values[graph.guards[k].condition] == 0) return k;
  return graph.guards.size();
}

// Operands of a node that its value is computed from.
static std::array<NodeId, 3> active_operands(Node const &node, std::span<double const> values) {
  std::array<NodeId, 3> operand = node.operand;
  bool const holds = values[operand[0]] != 0;
  if (node.op == Op::select || node.op == Op::wide_select) operand[holds ? 2 : 1] = no_node;
  if (node.op == Op::logical_and && !holds) operand[1] = no_node;
  if (node.op == Op::logical_or && holds) operand[1] = no_node;
  return operand;
}

std::vector<char> active_nodes(Graph const &graph, std::span<double const> values) {
  std::vector<char> active(graph.nodes.size(), 0);
  std::size_t const failing = first_failing_guard(graph, values);
  for (std::size_t k = 0; k < graph.guards.size() && k <= failing; ++k) active[graph.guards[k].condition] = 1;
  if (failing == graph.guards.size())
    for (NodeId result : graph.results) active[result] = 1;
  if (failing == graph.guards.size() && graph.last_effect != no_node) active[graph.last_effect] = 1;
  for (std::size_t id = graph.nodes.size(); id-- > 0;)
    if (active[id] && !is_leaf(graph.nodes[id].op))
      for (NodeId operand : active_operands(graph.nodes[id], values))
        if (operand != no_node) active[operand] = 1;
  return active;
}

// Whether a truncated index, or a conversion to integer, is in range.
static bool is_within(double value, double low, double end) { return value > low - 1 && value < end; }

static bool is_defined(Graph const &graph, Node const &node, std::span<double const> values) {
  auto operand = [&](std::size_t i) { return values[node.operand[i]]; };
  constexpr double two_to_31 = 0x1p31, two_to_53 = 0x1p53, two_to_63 = 0x1p63;
  switch (node.op) {
  // C leaves the sign of a computed NaN open; that of a constant NaN is the program's own.
  case Op::copysign: return graph.nodes[node.operand[1]].is_constant() || !std::isnan(operand(1));
  case Op::int32:
  case Op::within_int32: return is_within(operand(0), -two_to_31, two_to_31);
  case Op::within_uint32: return is_within(operand(0), 0, 2 * two_to_31);
  case Op::within_double: return is_within(operand(0), -two_to_53, two_to_53);
  case Op::int64:
  case Op::wide_int: return operand(0) >= -two_to_63 && operand(0) < two_to_63;
  case Op::wide_uint: return operand(0) >= -two_to_63 && operand(0) < 2 * two_to_63;
  case Op::wide_udiv:
  case Op::wide_urem: return integers::bits(operand(1)) != 0;
  case Op::wide_div:
  case Op::wide_rem:
    return integers::bits(operand(1)) != 0 &&
           (integers::bits(operand(0)) != std::uint64_t{1} << 63 || integers::bits(operand(1)) != ~std::uint64_t{0});
  case Op::lookup:
  case Op::lookup2: {
    std::vector<std::size_t> const &extents = graph.tables[table_of(graph, node)].extents;
    for (std::size_t i = 0; i < extents.size(); ++i)
      if (!is_within(operand(1 + i), 0, static_cast<double>(extents[i]))) return false;
    return true;
  }
  default: return true;
  }
}

// Whether a zero reaches an operation that sees its sign, except a constant, whose sign is the program's own.
static bool sees_zero_sign(Graph const &graph, Node const &node, std::span<double const> values) {
  auto is_zero = [&](NodeId id) { return id != no_node && !graph.nodes[id].is_constant() && values[id] == 0; };
  if (node.op == Op::call) {
    std::optional<ComplexFunction> const function = find_complex_function(graph.externals[function_of(graph, node)]);
    if (!function || !info(*function).has_cut) return false;
    std::vector<NodeId> const arguments = arguments_of(graph, node.operand[0]);
    return std::any_of(arguments.begin(), arguments.end(), is_zero);
  }
  return info(node.op).has(flag::ZERO_SIGN) && std::any_of(node.operand.begin(), node.operand.end(), is_zero);
}

// Infinite constants of the program, and nodes that pass them on.
static std::vector<char> own_infinities(Graph const &graph, std::span<double const> values) {
  std::vector<char> is_own(graph.nodes.size(), 0);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!std::isinf(values[id])) continue;
    is_own[id] = node.is_constant() ? 1 : 0;
    if (is_leaf(node.op) || !hands_on(node.op)) continue;
    for (NodeId operand : active_operands(node, values)) // the magnitude is that of one of them
      if (operand != no_node && std::isinf(values[operand]) && is_own[operand]) is_own[id] = 1;
  }
  return is_own;
}

// Premise P1 at one node: its result and operands are finite.
static bool is_finite(Graph const &graph, std::size_t id, std::span<double const> values,
                      std::vector<char> const &own_infinities) {
  Node const &node = graph.nodes[id];
  auto is_number = [&](std::size_t k) { return is_wide(graph.nodes[k].op) || std::isfinite(values[k]); };
  if (!is_number(id) && !own_infinities[id]) return false;
  if (is_leaf(node.op) || takes_infinity(node.op)) return true;
  return std::all_of(node.operand.begin(), node.operand.end(),
                     [&](NodeId operand) { return operand == no_node || is_number(operand); });
}

Premises check_premises(Graph const &graph, std::span<double const> values) {
  Premises premises;
  std::vector<char> const own = own_infinities(graph, values);
  std::vector<char> const active = active_nodes(graph, values);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!active[id]) continue;
    Node const &node = graph.nodes[id];
    if (!is_finite(graph, id, values, own)) premises.finite = false;
    if (is_leaf(node.op)) continue;
    if (!is_defined(graph, node, values)) premises.defined = false;
    if (sees_zero_sign(graph, node, values)) premises.zero_sign_unseen = false;
  }
  return premises;
}

Evaluation evaluate_sample(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters,
                           CallExternal const &call, Rounding rounding) {
  return evaluation_of(graph, evaluate(graph, inputs, parameters, call, rounding));
}

Evaluation evaluation_of(Graph const &graph, std::span<double const> values) {
  Evaluation result{{}, check_premises(graph, values), first_failing_guard(graph, values)};
  for (NodeId output : graph.results) result.outputs.push_back(values[output]);
  return result;
}

} // namespace symreal
