#include "engine/optimise/differentiate/differentiate.h"

#include "engine/graph/implicit.h"
#include "engine/graph/opaque.h"
#include "engine/optimise/differentiate/calls.h"
#include "engine/optimise/differentiate/matrix.h"
#include "engine/optimise/differentiate/path.h"
#include "engine/optimise/differentiate/request.h"
#include "engine/optimise/differentiate/stored_matrix.h"
#include "engine/optimise/differentiate/sweeps.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace symreal {

namespace {

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

void add_matrix(Graph &graph, DerivativeRequest const &request, MatrixElements elements) {
  StoredMatrix stored = store(graph, request, std::move(elements));
  stored.matrix.output = static_cast<std::uint32_t>(graph.outputs.size());
  add_object(graph.outputs, request.name, request.is_packed() ? std::vector{stored.results.size()} : request.extents(),
             request.place);
  graph.results.insert(graph.results.end(), stored.results.begin(), stored.results.end());
  graph.matrices.push_back(std::move(stored.matrix));
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

} // namespace symreal
