#include "differentiate/sweeps.h"

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
    expressions.for_each_slope(id, [&](NodeId operand, auto const &partial) {
      if (NodeId const along = tangent[operand]; along != no_node)
        tangent[id] = expressions.sum(tangent[id], expressions.product(along, partial()));
    });
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
    expressions.for_each_slope(id, [&](NodeId operand, auto const &partial) {
      if (carries[operand])
        adjoint[operand] = expressions.sum(adjoint[operand], expressions.product(adjoint[id], partial()));
    });
  }
  return result;
}

} // namespace symreal
