#include "engine/optimise/differentiate/differentiate.h"

#include "engine/graph/implicit.h"
#include "engine/graph/statistics.h"
#include "engine/ops/operation.h"
#include "engine/optimise/differentiate/request.h"
#include "engine/optimise/differentiate/sweeps.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace symreal {

namespace {

// Derivative matrices as lists of structurally nonzero elements.
struct MatrixElement {
  std::uint32_t row, column;
  NodeId node;
};
using MatrixElements = std::vector<MatrixElement>; // row-major

enum class Way : std::uint8_t { forward, reverse };

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

// Jacobian of the nodes `rows` by the input slots `columns`.
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

// Jacobian by the mode that costs less by the cost table. The lower triangle of a symmetric matrix is mirrored.
MatrixElements cheapest_jacobian(Graph &graph, std::vector<NodeId> const &rows,
                                 std::vector<std::uint32_t> const &columns, bool is_symmetric = false) {
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
    OperationCounts const counts = live_operations(with);
    double sum = 0;
    for (OperationInfo const &row : operations()) sum += usual_costs()[row.op] * static_cast<double>(counts[row.op]);
    return sum;
  };
  std::pair<Graph, MatrixElements> forward = made(Way::forward), reverse = made(Way::reverse);
  std::pair<Graph, MatrixElements> &best = cost(reverse) < cost(forward) ? reverse : forward;
  graph = std::move(best.first);
  return std::move(best.second);
}

Place place_or(Graph const &graph, NodeId id, Place const &otherwise) {
  Place const place = place_of(graph, id);
  return place.file.empty() ? otherwise : place;
}

// Name of the operation or function that has no derivative.
std::string name_of(Graph const &graph, NodeId id) {
  Node node = graph.nodes[id];
  if (node.op == Op::returned) node = graph.nodes[node.operand[0]];
  return is_call(node.op) ? graph.externals[function_of(graph, node)].name : std::string(info(node.op).name);
}

void require_differentiable(Graph const &graph, DerivativePath const &path, DerivativeRequest const &request) {
  if (path.unknown.empty()) return;
  NodeId const id = path.unknown.back();
  fail(DiagnosticId::not_differentiable, place_or(graph, id, request.place),
       "'" + name_of(graph, id) + "' has no derivative that " + request.name + " could go through");
}

// Reports each operation once per source location.
void report_jumps(Graph const &graph, DerivativePath const &path, DerivativeRequest const &request,
                  Report const &report) {
  std::set<std::pair<Op, std::string>> told;
  for (NodeId const id : path.jumps) {
    Op const op = graph.nodes[id].op;
    Place const place = place_or(graph, id, request.place);
    if (!told.emplace(op, to_string(place)).second) continue;
    report({DiagnosticId::derivative_of_steps, place,
            request.name + " leads through '" + std::string(info(op).name) + "', which jumps"});
  }
}

Object &add_object(std::vector<Object> &objects, std::string label, std::vector<std::size_t> extents,
                   Place const &place) {
  std::uint32_t const first = objects.empty() ? 0 : objects.back().first + objects.back().count;
  Object object{std::move(label), std::move(extents), first, 1, place};
  object.count = static_cast<std::uint32_t>(number_count(object.extents, {}));
  return objects.emplace_back(std::move(object));
}

// Slots of an added input, a direction or weights, with the recorded value 1. Requests share an input of the same label
// among the objects from number `recorded` on.
std::vector<std::uint32_t> add_seeds(Graph &graph, DerivativeRequest const &request, std::size_t recorded) {
  std::string const label = request.seed_label();
  auto const added = std::span(graph.inputs).subspan(recorded);
  auto const found = std::ranges::find(added, label, &Object::label);
  std::uint32_t first = 0;
  if (found != added.end()) {
    first = found->first;
  } else {
    first = add_object(graph.inputs, label, {request.seed_count()}, {}).first;
    graph.input_values.resize(graph.input_values.size() + request.seed_count(), 1);
  }
  std::vector<std::uint32_t> slots(request.seed_count());
  std::iota(slots.begin(), slots.end(), first);
  return slots;
}

std::vector<NodeId> nodes_of(Graph const &graph, std::vector<std::uint32_t> const &output_slots) {
  std::vector<NodeId> nodes;
  for (std::uint32_t const slot : output_slots) nodes.push_back(graph.results[slot]);
  return nodes;
}

// Jacobian-vector product: forward along the direction `seeds`, or reverse with the weights `seeds`.
std::vector<NodeId> product(Way way, Graph &graph, DerivativeRequest const &request, std::vector<NodeId> const &rows,
                            std::vector<std::uint32_t> const &seeds) {
  std::vector<char> const carries = find_path(graph, rows, request.input_slots).carries;
  Expressions expressions(graph);
  std::vector<NodeId> elements, seed_nodes;
  for (std::uint32_t const slot : seeds) seed_nodes.push_back(expressions.input(slot));
  if (seeds.empty()) seed_nodes.assign(rows.size(), expressions.constant(1));
  if (way == Way::forward) {
    std::vector<NodeId> direction(graph.input_count(), no_node);
    for (std::size_t j = 0; j < seeds.size(); ++j) direction[request.input_slots[j]] = seed_nodes[j];
    elements = forward_sweep(expressions, carries, rows, direction);
  } else {
    auto const all = reverse_sweep(expressions, carries, rows, seed_nodes, graph.input_count());
    for (std::uint32_t const slot : request.input_slots) elements.push_back(all[slot]);
  }
  for (NodeId &element : elements) element = expressions.number(element);
  expressions.finish();
  return elements;
}

// Adds a derivative matrix as an output: dense, the lower triangle, or nonzeros only. Throws matrix_too_large.
void add_matrix(Graph &graph, DerivativeRequest const &request, MatrixElements elements) {
  constexpr std::size_t most_elements = std::size_t{1} << 20; // each appears in the generated code
  std::vector<std::size_t> const extents = request.extents();
  if (request.is_symmetric)
    std::erase_if(elements, [](MatrixElement const &element) { return element.column > element.row; });
  std::size_t const whole = request.is_symmetric ? extents[0] * (extents[0] + 1) / 2 : extents[0] * extents[1];
  std::size_t const count = request.is_sparse ? elements.size() : whole;
  if (count > most_elements)
    fail(DiagnosticId::matrix_too_large, request.place,
         request.name + " would store " + std::to_string(count) +
             (request.is_sparse ? " numbers that are not zero by structure" : " numbers") + "; the most are " +
             std::to_string(most_elements));
  DerivativeMatrix matrix{static_cast<std::uint32_t>(graph.outputs.size()), static_cast<std::uint32_t>(extents[0]),
                          static_cast<std::uint32_t>(extents[1]), request.is_packed(), request.is_symmetric};
  if (request.is_sparse) {
    for (auto const &[row, column, node] : elements) {
      graph.results.push_back(node);
      matrix.row.push_back(row), matrix.column.push_back(column);
    }
  } else {
    Expressions expressions(graph);
    NodeId const zero = expressions.constant(0);
    expressions.finish();
    auto next = elements.begin();
    for (std::uint32_t i = 0; i < matrix.rows; ++i)
      for (std::uint32_t j = 0; j < (matrix.is_symmetric ? i + 1 : matrix.columns); ++j) {
        bool const is_there = next != elements.end() && next->row == i && next->column == j;
        graph.results.push_back(is_there ? next->node : zero);
        if (is_there || matrix.is_symmetric) matrix.row.push_back(i), matrix.column.push_back(j);
        next += is_there;
      }
  }
  add_object(graph.outputs, request.name, request.is_packed() ? std::vector{count} : extents, request.place);
  graph.matrices.push_back(std::move(matrix));
}

void add_derivative(Graph &graph, DerivativeRequest const &request, std::size_t recorded, Report const &report) {
  std::vector<NodeId> const rows = nodes_of(graph, request.output_slots);
  DerivativePath const path = find_path(graph, rows, request.input_slots);
  require_differentiable(graph, path, request);
  report_jumps(graph, path, request, report);
  std::vector<std::uint32_t> const seeds =
      request.seed_count() == 0 ? std::vector<std::uint32_t>() : add_seeds(graph, request, recorded);
  if (request.kind == DerivativeKind::jacobian)
    return add_matrix(graph, request, cheapest_jacobian(graph, rows, request.input_slots));
  Way const way = request.kind == DerivativeKind::jvp ? Way::forward : Way::reverse;
  std::vector<NodeId> const elements = product(way, graph, request, rows, seeds);
  if (request.kind == DerivativeKind::hessian) // a program function may have a first derivative only
    require_differentiable(graph, find_path(graph, elements, request.input_slots), request);
  if (request.kind == DerivativeKind::hessian)
    return add_matrix(graph, request, cheapest_jacobian(graph, elements, request.input_slots, true));
  add_object(graph.outputs, request.name, request.extents(), request.place);
  graph.results.insert(graph.results.end(), elements.begin(), elements.end());
}

} // namespace

Graph differentiate(Graph graph, std::span<DerivativeWish const> wishes, Report const &report) {
  std::vector<DerivativeRequest> read; // before inputs and outputs are added
  for (DerivativeWish const &wish : wishes) {
    read.push_back(read_request(wish, graph));
    for (DerivativeRequest const &other : std::span(read).first(read.size() - 1))
      if (other.name == read.back().name)
        fail(DiagnosticId::bad_derivative, wish.place, wish.text + " is asked for twice");
  }
  add_derivative_functions(graph);
  std::size_t const recorded = graph.inputs.size();
  for (std::size_t k = 0; k < wishes.size(); ++k) {
    add_derivative(graph, read[k], recorded, report);
    graph.derivatives.push_back(wishes[k].text);
  }
  return without_implicit(std::move(graph));
}

Graph derivatives_of(Graph graph, std::size_t own_outputs) {
  std::uint32_t const first = graph.outputs[own_outputs].first;
  graph.outputs.erase(graph.outputs.begin(), graph.outputs.begin() + static_cast<std::ptrdiff_t>(own_outputs));
  for (Object &output : graph.outputs) output.first -= first;
  graph.results.erase(graph.results.begin(), graph.results.begin() + first);
  for (DerivativeMatrix &matrix : graph.matrices) matrix.output -= static_cast<std::uint32_t>(own_outputs);
  graph.states.clear(); // their time derivatives are among the erased outputs
  graph.derivatives_alone = true;
  return graph;
}

std::vector<double> unpacked(DerivativeMatrix const &matrix, std::span<double const> stored) {
  if (!matrix.is_packed) return {stored.begin(), stored.end()};
  std::vector<double> whole(std::size_t{matrix.rows} * matrix.columns, 0);
  for (std::size_t k = 0; k < stored.size(); ++k) {
    whole[std::size_t{matrix.row[k]} * matrix.columns + matrix.column[k]] = stored[k];
    if (matrix.is_symmetric) whole[std::size_t{matrix.column[k]} * matrix.columns + matrix.row[k]] = stored[k];
  }
  return whole;
}

} // namespace symreal
