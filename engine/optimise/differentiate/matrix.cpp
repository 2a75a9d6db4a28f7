#include "engine/optimise/differentiate/matrix.h"

#include "engine/graph/statistics.h"
#include "engine/ops/cost_model.h"
#include "engine/optimise/differentiate/path.h"
#include "engine/optimise/differentiate/sweeps.h"

#include <algorithm>

namespace symreal {

namespace {

double cost_of(Graph const &graph) {
  OperationCounts const counts = live_operations(graph);
  double cost = 0;
  for (OperationInfo const &row : operations()) cost += usual_costs()[row.op] * static_cast<double>(counts[row.op]);
  return cost;
}

void sort_by_row(MatrixElements &elements) {
  std::ranges::sort(elements, {}, [](MatrixElement const &one) { return std::pair(one.row, one.column); });
}

MatrixElements mirrored(MatrixElements const &elements) {
  MatrixElements result;
  for (auto const &[row, column, node] : elements) {
    if (row >= column) result.push_back({row, column, node});
    if (row > column) result.push_back({column, row, node});
  }
  sort_by_row(result);
  return result;
}

} // namespace

MatrixElements jacobian_by(Way way, Graph &graph, std::vector<NodeId> const &rows,
                           std::vector<std::uint32_t> const &columns) {
  std::vector<char> const carries = find_path(graph, rows, columns).carries;
  Expressions expressions(graph);
  MatrixElements elements;
  NodeId const one = expressions.constant(1);
  auto const add = [&](std::size_t row, std::size_t column, NodeId node) {
    Node const found = node == no_node ? Node::constant(0) : expressions.node(node);
    if (!found.is_constant() || found.value() != 0)
      elements.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), node});
  };
  if (way == Way::reverse) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      auto const row = reverse_sweep(expressions, carries, {&rows[i], 1}, {&one, 1}, graph.input_count());
      for (std::size_t j = 0; j < columns.size(); ++j) add(i, j, row[columns[j]]);
    }
  } else {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      std::vector<NodeId> direction(graph.input_count(), no_node);
      direction[columns[j]] = one;
      auto const column = forward_sweep(expressions, carries, rows, direction);
      for (std::size_t i = 0; i < rows.size(); ++i) add(i, j, column[i]);
    }
    sort_by_row(elements);
  }
  expressions.finish();
  return elements;
}

MatrixElements cheapest_jacobian(Graph &graph, std::vector<NodeId> const &rows,
                                 std::vector<std::uint32_t> const &columns, bool is_symmetric) {
  if (rows.size() == 1 || columns.size() == 1)
    return jacobian_by(rows.size() == 1 ? Way::reverse : Way::forward, graph, rows, columns);
  auto const made = [&](Way way) {
    std::pair<Graph, MatrixElements> result{graph, {}};
    result.second = jacobian_by(way, result.first, rows, columns);
    if (is_symmetric) result.second = mirrored(result.second);
    return result;
  };
  auto const cost = [](std::pair<Graph, MatrixElements> const &one) {
    Graph with = one.first;
    for (MatrixElement const &element : one.second) with.results.push_back(element.node);
    return cost_of(with);
  };
  std::pair<Graph, MatrixElements> forward = made(Way::forward), reverse = made(Way::reverse);
  std::pair<Graph, MatrixElements> &best = cost(reverse) < cost(forward) ? reverse : forward;
  graph = std::move(best.first);
  return std::move(best.second);
}

} // namespace symreal
