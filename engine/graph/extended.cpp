#include "engine/graph/extended.h"

#include "engine/graph/evaluate.h"
#include "engine/graph/evaluate_in.h"
#include "engine/graph/graph.h"

namespace symreal {

namespace {

// Perturbs by one or two units in the last place: for perturbation 1 upwards, else up or down by a fixed hash of the
// node. Random directions alone may cancel between successive nodes every time.
long double moved(long double number, std::size_t id, std::uint64_t perturbation,
                  long double unit = std::numeric_limits<long double>::epsilon()) {
  std::uint64_t mixed = (4 * id + perturbation) * 0x9e3779b97f4a7c15;
  mixed = (mixed ^ (mixed >> 31)) * 0xbf58476d1ce4e5b9;
  return number * (1 + (perturbation == 1 || mixed >> 63 != 0 ? unit : -unit));
}

bool is_of_call(Op op) { return op == Op::argument || op == Op::call || op == Op::returned; }

// Results of calls, which take and return doubles. A perturbation moves arguments and results by a unit of a double.
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
  // Whether the argument may be an integer: a constant, or the result of a conversion.
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

long double evaluate_extended(Op op, long double x, long double y, long double z) {
  return evaluate_in<long double>(op, x, y, z);
}

std::string obstacle_to_extended(Graph const &graph, bool calls) {
  if (extended_bits <= std::numeric_limits<double>::digits) return "this machine has no numbers wider than double";
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Op const op = graph.nodes[id].op;
    if (live[id] && !is_leaf(op) && reality_of(op) == Reality::none && !(calls && is_of_call(op)))
      return "'" + std::string(info(op).name) + "' is not an operation on real numbers";
  }
  return {};
}

std::optional<std::vector<long double>> evaluate_extended(Graph const &graph, std::span<double const> inputs,
                                                          std::span<double const> parameters,
                                                          std::span<double const> values, CallExternal const &call) {
  ExtendedCalls calls(graph, call, 0);
  auto const leaf = [&](NodeId id, Node const &node, std::vector<long double> const &wide) -> long double {
    if (node.op == Op::input) return inputs[node.slot()];
    if (node.op == Op::parameter) return parameters[node.slot()];
    return calls.value(id, wide);
  };
  std::optional<std::vector<long double>> const wide =
      evaluate_nodes<long double>(graph, values, leaf, [](NodeId, long double) {});
  if (!wide) return std::nullopt;
  std::vector<long double> outputs;
  for (NodeId result : graph.results) outputs.push_back((*wide)[result]);
  return outputs;
}

ExtendedNeighbourhood::ExtendedNeighbourhood(Graph const &graph, std::vector<NodeId> const &nodes,
                                             std::span<double const> parameters, std::vector<double> values,
                                             CallExternal call)
    : graph_(graph),
      nodes_(nodes),
      parameters_(parameters),
      values_(std::move(values)),
      call_(std::move(call)),
      active_(active_nodes(graph, values_)) {}

std::vector<long double> ExtendedNeighbourhood::at(std::span<long double const> inputs,
                                                   std::uint64_t perturbation) const {
  ExtendedCalls calls(graph_, call_, perturbation);
  auto const leaf = [&](NodeId id, Node const &node, std::vector<long double> const &wide) -> long double {
    if (node.op == Op::input) return inputs[node.slot()];
    if (node.op == Op::parameter) return parameters_[node.slot()];
    return calls.value(id, wide);
  };
  auto const move = [&](NodeId id, long double &number) {
    Op const op = graph_.nodes[id].op;
    if (perturbation != 0 && reality_of(op) == Reality::formula && !info(op).has(flag::QUIET))
      number = moved(number, id, perturbation);
  };
  std::vector<char> others;
  auto const otherwise = [&](NodeId id) {
    others.resize(graph_.nodes.size(), 0);
    others[id] = 1;
    return true;
  };
  std::vector<long double> const wide = *evaluate_nodes<long double>(graph_, values_, active_, leaf, move, otherwise);
  if (!others.empty()) spread(others);
  std::vector<long double> result;
  for (NodeId const node : nodes_)
    result.push_back(others.empty() || !others[node] ? wide[node] : std::numeric_limits<long double>::quiet_NaN());
  return result;
}

// Propagates differing choices to all dependent nodes, except through the arm that a select did not take.
void ExtendedNeighbourhood::spread(std::vector<char> &otherwise) const {
  for (std::size_t id = 0; id < otherwise.size(); ++id) {
    Node const &node = graph_.nodes[id];
    if (!active_[id] || is_leaf(node.op)) continue;
    for (std::size_t i = 0; i < arity(node.op); ++i) {
      bool const is_left = node.op == Op::select && i != 0 && (i == 1) != (values_[node.operand[0]] != 0);
      if (!is_left && node.operand[i] != no_node) otherwise[id] |= otherwise[node.operand[i]];
    }
  }
}

} // namespace symreal
