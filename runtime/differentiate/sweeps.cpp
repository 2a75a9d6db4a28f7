#include "differentiate/sweeps.h"

#include "differentiate/rules.h"

namespace symreal {

std::vector<NodeId> forward_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> direction) {
  std::vector<NodeId> tangent(carries.size(), no_node);
  for (NodeId id = 0; id < carries.size(); ++id) {
    if (!carries[id]) continue;
    Node const node = expressions.node(id);
    if (node.op == Op::input) tangent[id] = direction[node.slot()];
    if (is_leaf(node.op)) continue;
    expressions.place_at(id);
    for (std::size_t i = 0; i < arity(node.op); ++i)
      if (NodeId const along = tangent[node.operand[i]]; along != no_node && slope_of(node.op, i) == Slope::formula)
        tangent[id] = expressions.sum(tangent[id], expressions.product(along, expressions.partial(id, i)));
  }
  std::vector<NodeId> result;
  for (NodeId const output : outputs) result.push_back(tangent[output]);
  return result;
}

std::vector<NodeId> reverse_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> weights,
                                  std::size_t inputs) {
  std::vector<NodeId> adjoint(carries.size(), no_node), result(inputs, no_node);
  for (std::size_t k = 0; k < outputs.size(); ++k)
    adjoint[outputs[k]] = expressions.sum(adjoint[outputs[k]], weights[k]);
  for (NodeId id = static_cast<NodeId>(carries.size()); id-- > 0;) {
    if (!carries[id] || adjoint[id] == no_node) continue;
    Node const node = expressions.node(id);
    if (node.op == Op::input) result[node.slot()] = expressions.sum(result[node.slot()], adjoint[id]);
    if (is_leaf(node.op)) continue;
    expressions.place_at(id);
    for (std::size_t i = 0; i < arity(node.op); ++i) {
      NodeId const operand = node.operand[i];
      if (!carries[operand] || slope_of(node.op, i) != Slope::formula) continue;
      adjoint[operand] =
          expressions.sum(adjoint[operand], expressions.product(adjoint[id], expressions.partial(id, i)));
    }
  }
  return result;
}

} // namespace symreal
