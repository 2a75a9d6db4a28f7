#include "engine/emit/print/constant_paths.h"

#include "engine/ops/operation.h"

#include <algorithm>
#include <map>

namespace symreal {
namespace {

std::span<NodeId const> operands(Node const &node) { return {node.operand.data(), arity(node.op)}; }

// Whether a compiler may evaluate the function, with results that differ from the library's.
bool may_be_folded(Op op) {
  return !is_leaf(op) && info(op).form == Form::call && !info(op).has(flag::ROUNDED | flag::QUIET | flag::OPAQUE);
}

// Marks nodes compared with a constant, for equality or twice by order: on some path the node is constant.
void add_compared(Graph const &graph, std::vector<char> &found) {
  std::map<std::pair<NodeId, NodeId>, int> ordered;
  for (Node const &node : graph.nodes) {
    if (is_leaf(node.op) || arity(node.op) != 2 || !info(node.op).has(flag::BOOLEAN)) continue;
    auto [x, c] = std::pair(node.operand[0], node.operand[1]);
    if (graph.nodes[x].is_constant()) std::swap(x, c);
    if (!graph.nodes[c].is_constant()) continue;
    bool const is_equality = node.op == Op::eq || node.op == Op::ne;
    if (is_equality || ++ordered[{x, c}] > 1) found[x] = 1;
  }
}

} // namespace

std::vector<char> constant_on_a_path(Graph const &graph, std::vector<char> const &inputs) {
  std::vector<char> found(graph.nodes.size(), 0);
  add_compared(graph, found);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (node.op == Op::input && !inputs.empty()) found[id] = inputs[node.slot()];
    if (is_leaf(node.op)) continue;
    OperationInfo const &operation = info(node.op);
    auto const may_be = [&](NodeId operand) { return found[operand] || graph.nodes[operand].is_constant(); };
    if (operation.form == Form::select)
      found[id] |= may_be(node.operand[1]) || may_be(node.operand[2]);
    else if (operation.has(flag::BOOLEAN) || operation.form == Form::local) // these have a few values, or branches
      found[id] = 1;
    else if (!operation.has(flag::STRUCTURE) && !may_be_folded(node.op)) // their operands are hidden
      found[id] |= std::ranges::all_of(operands(node), may_be);
  }
  return found;
}

bool hides_arguments(Graph const &graph) {
  std::vector<char> const found = constant_on_a_path(graph);
  return std::ranges::any_of(graph.nodes, [&](Node const &node) {
    return !is_leaf(node.op) && hidden_operand(graph, found, node) != no_node;
  });
}

NodeId hidden_operand(Graph const &graph, std::vector<char> const &found, Node const &call) {
  return may_be_folded(call.op) ? hidden_argument(graph, found, operands(call)) : no_node;
}

NodeId hidden_argument(Graph const &graph, std::vector<char> const &found, std::span<NodeId const> arguments) {
  auto const is_constant = [&](NodeId argument) { return graph.nodes[argument].is_constant(); };
  auto const may_be = [&](NodeId argument) { return found[argument] || is_constant(argument); };
  if (arguments.empty() || !std::ranges::all_of(arguments, may_be)) return no_node;
  auto const hidden = std::ranges::find_if_not(arguments, is_constant);
  return hidden == arguments.end() ? arguments.front() : *hidden;
}

} // namespace symreal
