#include "differentiate/dual_numbers.h"

#include "differentiate/point_duals.h"

namespace symreal {

namespace {

using Vector = PointDuals::Vector;

Vector unit(std::size_t size, std::size_t at) {
  Vector vector(size, 0);
  vector[at] = 1;
  return vector;
}

Vector scattered(std::size_t size, std::vector<std::uint32_t> const &slots, std::span<double const> numbers) {
  Vector vector(size, 0);
  for (std::size_t k = 0; k < numbers.size(); ++k) vector[slots[k]] += numbers[k];
  return vector;
}

void add_picked(Vector const &all, std::vector<std::uint32_t> const &slots, Vector &result) {
  for (std::uint32_t const slot : slots) result.push_back(all[slot]);
}

void add_jacobian(PointDuals const &point, DerivativeRequest const &request, Graph const &graph, Vector &result) {
  std::vector<std::uint32_t> const &rows = request.output_slots, &columns = request.input_slots;
  if (rows.size() <= columns.size()) {
    for (std::uint32_t const row : rows) add_picked(point.reverse(unit(graph.output_count(), row)), columns, result);
    return;
  }
  std::size_t const first = result.size();
  result.resize(first + rows.size() * columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j) {
    Vector const column = point.forward(unit(graph.input_count(), columns[j]));
    for (std::size_t i = 0; i < rows.size(); ++i) result[first + i * columns.size() + j] = column[rows[i]];
  }
}

} // namespace

Vector dual_numbers(Graph const &graph, std::span<DerivativeRequest const> requests,
                    std::span<std::span<double const> const> seeds, std::span<double const> inputs,
                    std::span<double const> parameters, CallExternal const &call) {
  PointDuals const point(graph, inputs, parameters, call);
  Vector result;
  for (std::size_t k = 0; k < requests.size(); ++k) {
    DerivativeRequest const &request = requests[k];
    std::vector<std::uint32_t> const &outputs = request.output_slots, &columns = request.input_slots;
    std::size_t const from = graph.input_count(), to = graph.output_count();
    switch (request.kind) {
    case DerivativeKind::jacobian:
    case DerivativeKind::gradient: add_jacobian(point, request, graph, result); break;
    case DerivativeKind::hessian: {
      Vector const weights = request.is_weighted ? scattered(to, outputs, seeds[k]) : unit(to, outputs[0]);
      for (std::uint32_t const column : columns) // which is a row as well
        add_picked(point.second(weights, unit(from, column)), columns, result);
      break;
    }
    case DerivativeKind::jvp: add_picked(point.forward(scattered(from, columns, seeds[k])), outputs, result); break;
    case DerivativeKind::vjp: add_picked(point.reverse(scattered(to, outputs, seeds[k])), columns, result); break;
    }
  }
  return result;
}

} // namespace symreal
