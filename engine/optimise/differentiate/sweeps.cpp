#include "engine/optimise/differentiate/sweeps.h"

#include "engine/optimise/differentiate/implicit_slopes.h"

namespace symreal {

std::vector<NodeId> forward_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> direction) {
  Graph const &graph = expressions.graph();
  std::vector<NodeId> tangent(carries.size(), no_node);
  TangentOf const tangent_of = [&](NodeId id) { return tangent[id]; };
  for (NodeId id = 0; id < carries.size(); ++id) {
    if (!carries[id]) continue;
    Node const node = expressions.node(id);
    if (node.op == Op::input) tangent[id] = direction[node.slot()];
    if (is_leaf(node.op)) continue;
    expressions.place_at(id);
    tangent[id] = tangent_along(graph, expressions, id, tangent_of);
  }
  std::vector<NodeId> result;
  for (NodeId const output : outputs) result.push_back(tangent[output]);
  return result;
}

std::vector<NodeId> reverse_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> weights,
                                  std::size_t inputs) {
  Graph const &graph = expressions.graph();
  std::vector<NodeId> adjoint(carries.size(), no_node), result(inputs, no_node);
  SolutionAdjoints solutions;
  AddAdjoint const add = [&](NodeId operand, NodeId one) {
    if (carries[operand]) adjoint[operand] = expressions.sum(adjoint[operand], one);
  };
  for (std::size_t k = 0; k < outputs.size(); ++k)
    adjoint[outputs[k]] = expressions.sum(adjoint[outputs[k]], weights[k]);
  for (NodeId id = static_cast<NodeId>(carries.size()); id-- > 0;) {
    if (!carries[id] || (adjoint[id] == no_node && !solutions.contains(id))) continue;
    Node const node = expressions.node(id);
    if (node.op == Op::input) result[node.slot()] = expressions.sum(result[node.slot()], adjoint[id]);
    if (is_leaf(node.op)) continue;
    expressions.place_at(id);
    hand_down(graph, expressions, id, adjoint[id], solutions, add);
  }
  return result;
}

} // namespace symreal
