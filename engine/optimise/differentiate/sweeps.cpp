#include "engine/optimise/differentiate/sweeps.h"

#include "engine/graph/implicit.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

namespace symreal {

namespace {

// Derivatives of implicit solutions: for x with r(x, p) = 0 they are -(dr/dx)^-1 dr/dp, where r is the residual that
// the program computes from x.
//
// A system, and the nodes of its residual that depend on the unknowns, in topological order.
struct ImplicitCone {
  ImplicitSystem system;
  std::vector<NodeId> nodes;

  bool has(NodeId id) const { return std::ranges::binary_search(nodes, id); }
  bool is_unknown(NodeId id) const { return std::ranges::find(system.unknowns, id) != system.unknowns.end(); }
};

ImplicitCone cone_of(Graph const &graph, NodeId call) {
  ImplicitCone cone{system_of(graph, call), {}};
  NodeId const first = std::ranges::min(cone.system.unknowns);
  std::vector<char> depends(call - first, 0), needed(call - first, 0);
  auto const operands = [&](NodeId id) {
    Node const &node = graph.nodes[id];
    return is_leaf(node.op) ? std::span<NodeId const>() : std::span<NodeId const>(node.operand);
  };
  for (NodeId const unknown : cone.system.unknowns) depends[unknown - first] = 1;
  for (NodeId id = first; id < call; ++id)
    for (NodeId const operand : operands(id))
      if (operand != no_node && operand >= first && depends[operand - first]) depends[id - first] = 1;
  for (NodeId const residual : cone.system.residuals)
    if (residual >= first) needed[residual - first] = 1;
  for (NodeId id = call; id-- > first;) {
    if (!needed[id - first] || !depends[id - first] || cone.is_unknown(id)) continue;
    cone.nodes.push_back(id);
    for (NodeId const operand : operands(id))
      if (operand != no_node && operand >= first) needed[operand - first] = 1;
  }
  std::ranges::reverse(cone.nodes);
  return cone;
}

// Row-major; no_node for a structural zero.
using SquareMatrix = std::vector<std::vector<NodeId>>;

SquareMatrix transposed(SquareMatrix const &matrix) {
  SquareMatrix result = matrix;
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j) result[j][i] = matrix[i][j];
  return result;
}

// Small dense linear system of symbolic expressions.
class LinearSystem {
public:
  LinearSystem(Expressions &expressions, SquareMatrix matrix, std::vector<NodeId> right)
      : expressions_(expressions),
        rows_(std::move(matrix)),
        count_(right.size()) {
    for (std::size_t i = 0; i < count_; ++i) rows_[i].push_back(right[i]); // augmented matrix
  }

  // Gaussian elimination with partial pivoting. Selects choose the pivot of the largest magnitude, which differs among
  // samples. Returns nullopt if the matrix is structurally singular.
  std::optional<std::vector<NodeId>> solved() {
    for (std::size_t k = 0; k < count_; ++k) {
      if (!choose_pivot(k)) return std::nullopt;
      for (std::size_t i = k + 1; i < count_; ++i) eliminate(i, k);
    }
    std::vector<NodeId> result(count_, no_node);
    for (std::size_t k = count_; k-- > 0;) {
      NodeId sum = rows_[k][count_];
      for (std::size_t j = k + 1; j < count_; ++j) sum = less(sum, rows_[k][j], result[j]);
      result[k] = expressions_.quotient(sum, rows_[k][k]);
    }
    return result;
  }

private:
  bool choose_pivot(std::size_t k) {
    std::size_t first = k;
    while (first < count_ && rows_[first][k] == no_node) ++first;
    if (first == count_) return false;
    std::swap(rows_[k], rows_[first]);
    for (std::size_t i = first + 1; i < count_; ++i) {
      if (rows_[i][k] == no_node) continue;
      NodeId const is_larger = expressions_.is_larger_magnitude(rows_[i][k], rows_[k][k]);
      for (std::size_t j = k; j <= count_; ++j) {
        NodeId const upper = rows_[k][j], lower = rows_[i][j];
        rows_[k][j] = expressions_.select(is_larger, lower, upper);
        rows_[i][j] = expressions_.select(is_larger, upper, lower);
      }
    }
    return true;
  }

  void eliminate(std::size_t i, std::size_t k) {
    if (rows_[i][k] == no_node) return;
    NodeId const factor = expressions_.quotient(rows_[i][k], rows_[k][k]);
    for (std::size_t j = k + 1; j <= count_; ++j) rows_[i][j] = less(rows_[i][j], factor, rows_[k][j]);
    rows_[i][k] = no_node;
  }

  // a - b c
  NodeId less(NodeId a, NodeId b, NodeId c) {
    return expressions_.sum(a, expressions_.negative(expressions_.product(b, c)));
  }

  Expressions &expressions_;
  SquareMatrix rows_;
  std::size_t count_;
};

using TangentOf = std::function<NodeId(NodeId)>;
NodeId tangent_along(Expressions &expressions, NodeId id, TangentOf const &tangent);

// Tangents of the residual along a direction in which the unknowns have the tangents `of_unknown`.
std::vector<NodeId> residual_along(Expressions &expressions, ImplicitCone const &cone, TangentOf const &of_unknown,
                                   TangentOf const &of_others) {
  std::map<NodeId, NodeId> own;
  TangentOf const tangent = [&](NodeId id) {
    if (cone.is_unknown(id)) return of_unknown(id);
    auto const found = own.find(id);
    return found != own.end() ? found->second : of_others(id);
  };
  for (NodeId const id : cone.nodes) own[id] = tangent_along(expressions, id, tangent);
  std::vector<NodeId> result;
  for (NodeId const residual : cone.system.residuals) result.push_back(tangent(residual));
  return result;
}

// Jacobian of the residual by the unknowns, row-major.
SquareMatrix jacobian_of(Expressions &expressions, ImplicitCone const &cone) {
  std::size_t const count = cone.system.unknowns.size();
  SquareMatrix matrix(count, std::vector<NodeId>(count, no_node));
  NodeId const one = expressions.constant(1);
  for (std::size_t j = 0; j < count; ++j) {
    auto const column = residual_along(
        expressions, cone, [&](NodeId id) { return id == cone.system.unknowns[j] ? one : no_node; },
        [](NodeId) { return no_node; });
    for (std::size_t i = 0; i < count; ++i) matrix[i][j] = column[i];
  }
  return matrix;
}

std::vector<NodeId> solution(Expressions &expressions, NodeId call, SquareMatrix matrix, std::vector<NodeId> right) {
  Graph const &graph = expressions.graph();
  auto found = LinearSystem(expressions, std::move(matrix), std::move(right)).solved();
  if (!found)
    fail(DiagnosticId::not_differentiable, place_of(graph, system_of(graph, call).unknowns[0]), // where x is computed
         "the residual in implicit(x, r) does not determine x: an element of it depends on none of x, or one of x has "
         "no "
         "influence on it");
  return std::move(*found);
}

// Tangent of a node from the tangents of its operands; no_node for zero. Recurses only into the residual of a solution.
// Throws not_differentiable if the residual does not determine the solution.
NodeId tangent_along(Expressions &expressions, NodeId id, TangentOf const &tangent) {
  Graph const &graph = expressions.graph();
  if (!is_implicit_solution(graph, id)) {
    NodeId sum = no_node;
    expressions.for_each_slope(id, [&](NodeId operand, auto const &partial) {
      if (NodeId const along = tangent(operand); along != no_node)
        sum = expressions.sum(sum, expressions.product(along, partial()));
    });
    return sum;
  }
  NodeId const call = graph.nodes[id].operand[0];
  ImplicitCone const cone = cone_of(graph, call);
  auto right = residual_along(expressions, cone, [](NodeId) { return no_node; }, tangent);
  for (NodeId &one : right) one = expressions.negative(one);
  auto const solved = solution(expressions, call, jacobian_of(expressions, cone), std::move(right));
  return solved[result_of(graph, graph.nodes[id])];
}

// Adjoints of the results of each implicit call that the reverse sweep has yet to reach.
using SolutionAdjoints = std::map<NodeId, std::vector<NodeId>>;
using AddAdjoint = std::function<void(NodeId operand, NodeId adjoint)>;
void hand_down(Expressions &expressions, NodeId id, NodeId adjoint, SolutionAdjoints &solutions, AddAdjoint const &add);

// Propagates the adjoints of a call's results: solves for weights of the residual, then sweeps its cone in reverse.
void hand_down_solution(Expressions &expressions, NodeId call, std::vector<NodeId> const &adjoints,
                        AddAdjoint const &add) {
  ImplicitCone const cone = cone_of(expressions.graph(), call);
  std::vector<NodeId> right;
  for (NodeId const one : adjoints) right.push_back(expressions.negative(one));
  auto const weights = solution(expressions, call, transposed(jacobian_of(expressions, cone)), std::move(right));
  std::map<NodeId, NodeId> own;
  SolutionAdjoints inner;
  AddAdjoint const add_own = [&](NodeId operand, NodeId one) {
    if (cone.is_unknown(operand)) return;
    if (!cone.has(operand)) return add(operand, one);
    auto const [sum, is_new] = own.try_emplace(operand, one);
    if (!is_new) sum->second = expressions.sum(sum->second, one);
  };
  for (std::size_t i = 0; i < weights.size(); ++i) add_own(cone.system.residuals[i], weights[i]);
  for (auto node = cone.nodes.rbegin(); node != cone.nodes.rend(); ++node) {
    auto const found = own.find(*node);
    hand_down(expressions, *node, found == own.end() ? no_node : found->second, inner, add_own);
  }
}

// Propagates the adjoint of a node to its operands. Adjoints of solutions wait in `solutions` until the sweep reaches
// their call.
void hand_down(Expressions &expressions, NodeId id, NodeId adjoint, SolutionAdjoints &solutions,
               AddAdjoint const &add) {
  Graph const &graph = expressions.graph();
  if (auto const found = solutions.find(id); found != solutions.end())
    return hand_down_solution(expressions, id, found->second, add);
  if (adjoint == no_node) return;
  if (is_implicit_solution(graph, id)) {
    Node const &node = graph.nodes[id];
    std::vector<NodeId> &all = solutions[node.operand[0]];
    all.resize(system_of(graph, node.operand[0]).unknowns.size(), no_node);
    all[result_of(graph, node)] = adjoint;
    return;
  }
  expressions.for_each_slope(
      id, [&](NodeId operand, auto const &partial) { add(operand, expressions.product(adjoint, partial())); });
}

// Per node, whether it depends on `inputs` through operands that `is_way(op, i)` allows.
template <class IsWay>
std::vector<char> dependent(Graph const &graph, std::span<std::uint32_t const> inputs, IsWay const &is_way) {
  std::vector<char> slots(graph.input_count(), 0);
  for (std::uint32_t const slot : inputs) slots[slot] = 1;
  std::vector<char> result(graph.nodes.size(), 0);
  for (std::size_t id = 0; id < result.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (node.op == Op::input) result[id] = slots[node.slot()];
    if (is_leaf(node.op)) continue;
    for (std::size_t i = 0; i < arity(node.op); ++i)
      if (result[node.operand[i]] && is_way(node.op, i)) result[id] = 1;
    for (NodeId const argument : differentiable_arguments(graph, static_cast<NodeId>(id)))
      if (result[argument]) result[id] = 1;
    if (is_implicit_call(graph, static_cast<NodeId>(id)))
      for (NodeId const residual : system_of(graph, static_cast<NodeId>(id)).residuals)
        if (result[residual]) result[id] = 1;
    if (is_implicit_solution(graph, static_cast<NodeId>(id))) result[id] = result[node.operand[0]];
  }
  return result;
}

} // namespace

DerivativePath find_path(Graph const &graph, std::span<NodeId const> outputs, std::span<std::uint32_t const> inputs) {
  std::vector<char> const reached = dependent(graph, inputs, [](Op, std::size_t) { return true; });
  DerivativePath path{
      dependent(graph, inputs, [](Op op, std::size_t i) { return slope_of(op, i) == Slope::formula; }), {}, {}};
  std::vector<char> needed(graph.nodes.size(), 0);
  for (NodeId const output : outputs) needed[output] = 1;
  // Passes the operands of node `id` on the path to `need`; records jumps and unknown derivatives.
  auto const look_at = [&](NodeId id, auto const &need) {
    Node const &node = graph.nodes[id];
    std::vector<NodeId> const arguments = differentiable_arguments(graph, id);
    for (NodeId const argument : arguments)
      if (reached[argument]) need(argument);
    if (is_implicit_solution(graph, id)) return need(node.operand[0]);
    if (!arguments.empty() || is_leaf(node.op)) return;
    bool jumps = false, is_unknown = false;
    for (std::size_t i = 0; i < arity(node.op); ++i) {
      if (!reached[node.operand[i]]) continue;
      Slope const slope = slope_of(node.op, i);
      if (slope == Slope::formula) need(node.operand[i]);
      jumps |= slope == Slope::steps || (slope == Slope::formula && jumps_between(node.op));
      is_unknown |= slope == Slope::unknown;
    }
    if (jumps) path.jumps.push_back(id);
    if (is_unknown) path.unknown.push_back(id);
  };
  auto const need = [&](NodeId operand) { needed[operand] = 1; };
  for (std::size_t k = needed.size(); k-- > 0;) {
    auto const id = static_cast<NodeId>(k);
    if (!needed[id]) continue;
    if (!is_implicit_call(graph, id)) {
      look_at(id, need);
      continue;
    }
    // The residual determines the derivative of the unknowns, not the algorithm that found them.
    ImplicitCone const cone = cone_of(graph, id);
    for (NodeId const residual : cone.system.residuals)
      if (!cone.has(residual)) need(residual);
    for (NodeId const inner : cone.nodes)
      if (graph.nodes[inner].op != Op::argument &&
          (graph.nodes[inner].op != Op::call || is_implicit_call(graph, inner)))
        look_at(inner, [&](NodeId operand) {
          if (!cone.has(operand) && !cone.is_unknown(operand)) need(operand);
        });
  }
  std::ranges::sort(path.jumps);
  std::ranges::sort(path.unknown);
  for (std::size_t id = 0; id < needed.size(); ++id) path.carries[id] &= needed[id];
  return path;
}

std::vector<NodeId> forward_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> direction) {
  std::vector<NodeId> tangent(carries.size(), no_node);
  TangentOf const tangent_of = [&](NodeId id) { return tangent[id]; };
  for (NodeId id = 0; id < carries.size(); ++id) {
    if (!carries[id]) continue;
    Node const node = expressions.node(id);
    if (node.op == Op::input) tangent[id] = direction[node.slot()];
    if (is_leaf(node.op)) continue;
    expressions.place_at(id);
    tangent[id] = tangent_along(expressions, id, tangent_of);
  }
  std::vector<NodeId> result;
  for (NodeId const output : outputs) result.push_back(tangent[output]);
  return result;
}

std::vector<NodeId> reverse_sweep(Expressions &expressions, std::vector<char> const &carries,
                                  std::span<NodeId const> outputs, std::span<NodeId const> weights,
                                  std::size_t inputs) {
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
    hand_down(expressions, id, adjoint[id], solutions, add);
  }
  return result;
}

} // namespace symreal
