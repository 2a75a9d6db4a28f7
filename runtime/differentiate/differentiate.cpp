#include "differentiate/differentiate.h"

#include "differentiate/path.h"
#include "differentiate/request.h"
#include "differentiate/sweeps.h"
#include "graph/opaque.h"
#include "graph/statistics.h"
#include "ops/cost_model.h"

#include <algorithm>
#include <set>

namespace symreal {

namespace {

Place place_or(Graph const &graph, NodeId id, Place const &otherwise) {
  Place const place = place_of(graph, id);
  return place.file.empty() ? otherwise : place;
}

// What stands behind a node without a derivative, in words.
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

// Each operation once a place.
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

double cost_of(Graph const &graph) {
  OperationCounts const counts = live_operations(graph);
  double cost = 0;
  for (OperationInfo const &row : operations()) cost += usual_costs()[row.op] * static_cast<double>(counts[row.op]);
  return cost;
}

Object &add_object(std::vector<Object> &objects, std::string label, std::vector<std::size_t> extents,
                   Place const &place) {
  std::uint32_t const first = objects.empty() ? 0 : objects.back().first + objects.back().count;
  Object object{std::move(label), std::move(extents), first, 1, place};
  object.count = static_cast<std::uint32_t>(number_count(object.extents, {}));
  return objects.emplace_back(std::move(object));
}

// The nodes of an input that is added: a direction, or weights. It is 1 where it was recorded.
std::vector<std::uint32_t> add_seeds(Graph &graph, std::string const &label, std::size_t count) {
  Object const &object = add_object(graph.inputs, label, {count}, {});
  graph.input_values.resize(graph.input_values.size() + count, 1);
  std::vector<std::uint32_t> slots;
  for (std::uint32_t k = 0; k < object.count; ++k) slots.push_back(object.first + k);
  return slots;
}

std::string joined(std::string text, std::vector<std::string> const &names) {
  for (std::string const &name : names) text += "_" + name;
  return text;
}

// Elements in the order of the added output; no_node is zero.
using Elements = std::vector<NodeId>;

std::vector<NodeId> nodes_of(Graph const &graph, std::vector<std::uint32_t> const &output_slots) {
  std::vector<NodeId> nodes;
  for (std::uint32_t const slot : output_slots) nodes.push_back(graph.results[slot]);
  return nodes;
}

enum class Way { forward, reverse };

// Of nodes of `graph`, row by row: a node by an input a column.
Elements jacobian_by(Way way, Graph &graph, std::vector<NodeId> const &rows,
                     std::vector<std::uint32_t> const &columns) {
  std::vector<char> const carries = find_path(graph, rows, columns).carries;
  Expressions expressions(graph);
  Elements elements(rows.size() * columns.size(), no_node);
  if (way == Way::reverse) {
    NodeId const one = expressions.constant(1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      auto const row = reverse_sweep(expressions, carries, {&rows[i], 1}, {&one, 1}, graph.input_count());
      for (std::size_t j = 0; j < columns.size(); ++j) elements[i * columns.size() + j] = row[columns[j]];
    }
  } else {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      std::vector<NodeId> direction(graph.input_count(), no_node);
      direction[columns[j]] = expressions.constant(1);
      auto const column = forward_sweep(expressions, carries, rows, direction);
      for (std::size_t i = 0; i < rows.size(); ++i) elements[i * columns.size() + j] = column[i];
    }
  }
  for (NodeId &element : elements) element = expressions.number(element);
  expressions.finish();
  return elements;
}

// The cheaper of both ways. Of a symmetric matrix the half above the diagonal is that below.
Elements cheapest_jacobian(Graph &graph, std::vector<NodeId> const &rows, std::vector<std::uint32_t> const &columns,
                           bool is_symmetric = false) {
  auto const made = [&](Way way) {
    std::pair<Graph, Elements> result{graph, {}};
    result.second = jacobian_by(way, result.first, rows, columns);
    for (std::size_t i = 0; is_symmetric && i < rows.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) result.second[j * columns.size() + i] = result.second[i * columns.size() + j];
    return result;
  };
  auto const cost = [](std::pair<Graph, Elements> const &one) {
    Graph with = one.first;
    with.results.insert(with.results.end(), one.second.begin(), one.second.end());
    return cost_of(with);
  };
  if (rows.size() == 1 || columns.size() == 1)
    return jacobian_by(rows.size() == 1 ? Way::reverse : Way::forward, graph, rows, columns);
  std::pair<Graph, Elements> forward = made(Way::forward), reverse = made(Way::reverse);
  std::pair<Graph, Elements> &best = cost(reverse) < cost(forward) ? reverse : forward;
  graph = std::move(best.first);
  return std::move(best.second);
}

// With a direction (jvp) or weights (vjp) as a further input.
Elements product_with_seeds(Graph &graph, DerivativeRequest const &request, std::vector<NodeId> const &rows) {
  bool const is_forward = request.kind == DerivativeKind::jvp;
  std::vector<char> carries = find_path(graph, rows, request.input_slots).carries;
  std::vector<std::uint32_t> const seeds =
      add_seeds(graph, is_forward ? joined("direction", request.inputs) : joined("weights", request.outputs),
                request.seed_count());
  Expressions expressions(graph);
  Elements elements, seed_nodes;
  for (std::uint32_t const slot : seeds) seed_nodes.push_back(expressions.input(slot));
  if (is_forward) {
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

void add_derivative(Graph &graph, DerivativeRequest const &request, Report const &report) {
  std::vector<NodeId> const rows = nodes_of(graph, request.output_slots);
  DerivativePath const path = find_path(graph, rows, request.input_slots);
  require_differentiable(graph, path, request);
  report_jumps(graph, path, request, report);
  Elements elements;
  switch (request.kind) {
  case DerivativeKind::jacobian: elements = cheapest_jacobian(graph, rows, request.input_slots); break;
  case DerivativeKind::gradient: elements = jacobian_by(Way::reverse, graph, rows, request.input_slots); break;
  case DerivativeKind::hessian: {
    Elements const gradient = jacobian_by(Way::reverse, graph, rows, request.input_slots);
    elements = cheapest_jacobian(graph, gradient, request.input_slots, true);
    break;
  }
  case DerivativeKind::jvp:
  case DerivativeKind::vjp: elements = product_with_seeds(graph, request, rows); break;
  }
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
  for (std::size_t k = 0; k < wishes.size(); ++k) {
    add_derivative(graph, read[k], report);
    graph.derivatives.push_back(wishes[k].text);
  }
  return graph;
}

} // namespace symreal
