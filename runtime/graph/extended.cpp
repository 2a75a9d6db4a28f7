#include "graph/extended.h"

#include "graph/call_results.h"
#include "graph/opaque.h"

#include <symreal/integer_functions.h>

#include <cmath>

namespace symreal {

namespace {

// What an operation has to do with real numbers.
enum class Reality : std::uint8_t {
  formula, // a function of them
  jump,    // one that is constant but for its jumps
  none,    // it depends on how numbers are stored, or on what is no number
};

Reality reality_of(Op op) {
  OperationInfo const &row = info(op);
  if (row.has(flag::OPAQUE | flag::WIDE | flag::TAKES_WIDE)) return Reality::none;
  switch (op) {
  case Op::f32:
  case Op::nextafter: return Reality::none;
  case Op::floor:
  case Op::ceil:
  case Op::trunc:
  case Op::round:
  case Op::rint:
  case Op::logb: return Reality::jump;
  default:
    return row.has(flag::BOOLEAN) || row.form == Form::local || row.form == Form::cast ? Reality::jump
                                                                                       : Reality::formula;
  }
}

[[maybe_unused]] int opaque() { return 0; }

// The reference semantics, in extended precision. What the table computes with integers in doubles is computed so.
template <class Number> Number evaluate_in(Op op, Number x, Number y, Number z) {
  using namespace flag;
  (void)z;
  switch (op) {
#define OPERATION(id, arity, form, c, precedence, evaluate, derivative, cost, flags, domain, doc)                      \
  case Op::id:                                                                                                         \
    if constexpr ((Form::form == Form::infix || Form::form == Form::prefix || Form::form == Form::call ||              \
                   Form::form == Form::select) &&                                                                      \
                  ((flags) & (WIDE | TAKES_WIDE)) == 0)                                                                \
      return static_cast<Number>(evaluate);                                                                            \
    else                                                                                                               \
      break;
#include <symreal/operations.def>
#undef OPERATION
  default: break;
  }
  return evaluate(op, static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
}

// Where an operation jumps, it has made a choice; two that are equal lie between the same jumps.
template <class Number> Number choice_of(Op op, Number x, Number y, Number result) {
  switch (op) {
  case Op::copysign: return std::signbit(y) ? 1 : 0;
  case Op::fmod: return std::trunc(x / y);
  case Op::remainder: return std::rint(x / y);
  default: return reality_of(op) == Reality::jump ? result : 0;
  }
}

// By a unit in the last place or two: the first time up; then up or down at random, but always the same of a node. At
// random alone two nodes in a row may cancel each time.
long double moved(long double number, std::size_t id, std::uint64_t perturbation,
                  long double unit = std::numeric_limits<long double>::epsilon()) {
  std::uint64_t mixed = (4 * id + perturbation) * 0x9e3779b97f4a7c15;
  mixed = (mixed ^ (mixed >> 31)) * 0xbf58476d1ce4e5b9;
  return number * (1 + (perturbation == 1 || mixed >> 63 != 0 ? unit : -unit));
}

bool is_of_call(Op op) { return op == Op::argument || op == Op::call || op == Op::returned; }

// What calls give, that take and give doubles. A perturbation moves both by a unit of a double.
class ExtendedCalls {
public:
  ExtendedCalls(Graph const &graph, CallExternal const &call, std::uint64_t perturbation)
      : graph_(graph),
        results_(graph, call),
        perturbation_(perturbation) {}

  long double value(NodeId id, std::vector<long double> const &wide) {
    Node const &node = graph_.nodes[id];
    if (node.op != Op::returned) return 0;
    NodeId const call = node.operand[0];
    std::vector<double> const &results =
        results_.of(call, function_of(graph_, graph_.nodes[call]), [&](NodeId argument) {
          return static_cast<double>(is_integer(argument) ? wide[argument] : perturbed(wide[argument], argument));
        });
    return perturbed(results[result_of(graph_, node)], id);
  }

private:
  // It may be one: a constant, or what has been converted.
  bool is_integer(NodeId argument) const {
    Node const &node = graph_.nodes[argument];
    return node.is_constant() || (!is_leaf(node.op) && reality_of(node.op) == Reality::jump);
  }
  long double perturbed(long double number, std::size_t id) const {
    return perturbation_ == 0 ? number : moved(number, id, perturbation_, std::numeric_limits<double>::epsilon());
  }

  Graph const &graph_;
  CallResults results_;
  std::uint64_t perturbation_;
};

} // namespace

long double evaluate_extended(Op op, long double x, long double y, long double z) { return evaluate_in(op, x, y, z); }

std::string obstacle_to_extended(Graph const &graph, bool calls) {
  if (extended_bits <= std::numeric_limits<double>::digits) return "this machine has no numbers wider than double";
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Op const op = graph.nodes[id].op;
    if (live[id] && !is_leaf(op) && reality_of(op) == Reality::none && !(calls && is_of_call(op)))
      return "'" + std::string(info(op).name) + "' is no operation on real numbers";
  }
  return {};
}

std::optional<std::vector<long double>> evaluate_extended(Graph const &graph, std::span<double const> inputs,
                                                          std::span<double const> parameters,
                                                          std::span<double const> values, CallExternal const &call) {
  std::vector<long double> const wide(inputs.begin(), inputs.end());
  return evaluate_extended(graph, std::span<long double const>(wide), parameters, values, 0, call);
}

std::optional<std::vector<long double>> evaluate_extended(Graph const &graph, std::span<long double const> inputs,
                                                          std::span<double const> parameters,
                                                          std::span<double const> values, std::uint64_t perturbation,
                                                          CallExternal const &call) {
  std::vector<char> const active = active_nodes(graph, values);
  ExtendedCalls calls(graph, call, perturbation);
  std::vector<long double> wide(graph.nodes.size(), 0);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!active[id]) continue;
    if (node.op == Op::constant) {
      wide[id] = node.value();
    } else if (node.op == Op::input) {
      wide[id] = inputs[node.slot()];
    } else if (node.op == Op::parameter) {
      wide[id] = parameters[node.slot()];
    } else if (is_of_call(node.op)) {
      wide[id] = calls.value(static_cast<NodeId>(id), wide);
    } else {
      auto operand = [&](std::size_t i, auto const &of) {
        return node.operand[i] == no_node ? 0 : of[node.operand[i]];
      };
      long double const x = operand(0, wide), y = operand(1, wide);
      wide[id] = evaluate_in(node.op, x, y, operand(2, wide));
      long double const in_double = choice_of<double>(node.op, operand(0, values), operand(1, values), values[id]);
      if (choice_of(node.op, x, y, wide[id]) != in_double) return std::nullopt;
      if (perturbation != 0 && reality_of(node.op) == Reality::formula && !info(node.op).has(flag::QUIET))
        wide[id] = moved(wide[id], id, perturbation);
    }
  }
  std::vector<long double> outputs;
  for (NodeId result : graph.results) outputs.push_back(wide[result]);
  return outputs;
}

} // namespace symreal
