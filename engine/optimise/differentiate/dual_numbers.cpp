#include "engine/optimise/differentiate/dual_numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace symreal {

namespace {

using Vector = DualNumbers::Vector;

// Tolerance of a matrix-vector product relative to the sum of its magnitudes: far above rounding unless much cancels.
constexpr long double most_off_product = 0x1p-30L;

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

bool is_hessian(DerivativeRequest const &request) { return request.kind == DerivativeKind::hessian; }

bool is_by_elements(DerivativeRequest const &request) {
  return request.is_matrix() || request.kind == DerivativeKind::gradient;
}

// Rows that are cheaper by one pass each. The longest of the other rows is a lower bound on the colours.
std::vector<char> direct_rows(Pattern const &rows) {
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t row) { return rows[row].size(); });
  std::size_t best = 0;
  auto const cost = [&](std::size_t direct) {
    return direct + (direct < rows.size() ? rows[order[direct]].size() : 0);
  };
  for (std::size_t direct = 1; direct <= rows.size(); ++direct)
    if (cost(direct) < cost(best)) best = direct;
  std::vector<char> is_direct(rows.size(), 0);
  for (std::size_t k = 0; k < best; ++k) is_direct[order[k]] = 1;
  return is_direct;
}

// Distinct numbers between -1 and 1.
std::vector<double> some_direction(std::size_t size) {
  std::vector<double> direction(size);
  for (std::size_t k = 0; k < size; ++k)
    direction[k] = std::remainder(0.4 + 0.7548776662466927 * static_cast<double>(k), 1.0) * 2;
  return direction;
}

} // namespace

DualNumbers::DualNumbers(Graph const &graph, std::vector<DerivativeRequest> requests, CallExternal call)
    : graph_(graph),
      requests_(std::move(requests)),
      call_(std::move(call)) {
  for (DerivativeRequest const &request : requests_)
    plans_.push_back(is_by_elements(request) ? plan_of(request) : Plan());
}

DualNumbers::Plan DualNumbers::plan_of(DerivativeRequest const &request) const {
  std::vector<std::uint32_t> position(graph_.input_count(), Colouring::none);
  for (std::size_t j = 0; j < request.input_slots.size(); ++j)
    position[request.input_slots[j]] = static_cast<std::uint32_t>(j);
  std::vector<NodeId> outputs;
  for (std::uint32_t const slot : request.output_slots) outputs.push_back(graph_.results[slot]);
  Pattern const all = is_hessian(request) ? coupled_inputs(graph_, outputs) : inputs_of(graph_, outputs);
  Plan plan;
  plan.rows.resize(is_hessian(request) ? request.input_slots.size() : outputs.size());
  for (std::size_t i = 0; i < plan.rows.size(); ++i)
    for (std::uint32_t const slot : all[is_hessian(request) ? request.input_slots[i] : i])
      if (position[slot] != Colouring::none) plan.rows[i].push_back(position[slot]);
  for (auto &row : plan.rows) std::ranges::sort(row);
  plan.is_direct = direct_rows(plan.rows);
  Pattern together = plan.rows;
  for (std::size_t i = 0; i < together.size(); ++i) {
    if (plan.is_direct[i]) together[i].clear();
    if (is_hessian(request)) std::erase_if(together[i], [&](std::uint32_t j) { return plan.is_direct[j] != 0; });
  }
  plan.colours = coloured(together, request.input_slots.size());
  return plan;
}

DualNumbers::Plan DualNumbers::without_structure(DerivativeRequest const &request) {
  std::size_t const rows = is_hessian(request) ? request.input_slots.size() : request.output_slots.size();
  return {Pattern(rows), {std::vector(request.input_slots.size(), Colouring::none), 0}, std::vector<char>(rows, 1)};
}

std::size_t DualNumbers::passes() const {
  std::size_t count = 0;
  for (Plan const &plan : plans_)
    count += 1 + plan.colours.count + static_cast<std::size_t>(std::ranges::count(plan.is_direct, 1));
  return count;
}

Vector DualNumbers::jacobian(PointDuals const &point, DerivativeRequest const &request, Plan const &plan) const {
  std::size_t const rows = request.output_slots.size(), columns = request.input_slots.size();
  Vector matrix(rows * columns, 0);
  for (std::size_t i = 0; i < rows; ++i) {
    if (!plan.is_direct[i]) continue;
    Vector const row = point.reverse(unit(graph_.output_count(), request.output_slots[i]));
    for (std::size_t j = 0; j < columns; ++j) matrix[i * columns + j] = row[request.input_slots[j]];
  }
  for (std::uint32_t colour = 0; colour < plan.colours.count; ++colour) {
    Vector direction(graph_.input_count(), 0);
    for (std::size_t j = 0; j < columns; ++j)
      if (plan.colours.colour[j] == colour) direction[request.input_slots[j]] = 1;
    Vector const slopes = point.forward(direction);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::uint32_t const j : plan.rows[i])
        if (!plan.is_direct[i] && plan.colours.colour[j] == colour)
          matrix[i * columns + j] = slopes[request.output_slots[i]];
  }
  return matrix;
}

// Each direct row is copied to its column by symmetry.
Vector DualNumbers::hessian(PointDuals const &point, DerivativeRequest const &request, Plan const &plan,
                            Vector const &weights) const {
  std::size_t const size = request.input_slots.size();
  Vector matrix(size * size, 0);
  for (std::uint32_t colour = 0; colour < plan.colours.count; ++colour) {
    Vector direction(graph_.input_count(), 0);
    for (std::size_t j = 0; j < size; ++j)
      if (plan.colours.colour[j] == colour) direction[request.input_slots[j]] = 1;
    Vector const change = point.second(weights, direction);
    for (std::size_t i = 0; i < size; ++i)
      for (std::uint32_t const j : plan.rows[i])
        if (!plan.is_direct[i] && plan.colours.colour[j] == colour)
          matrix[i * size + j] = change[request.input_slots[i]];
  }
  for (std::size_t j = 0; j < size; ++j) {
    if (!plan.is_direct[j]) continue;
    Vector const change = point.second(weights, unit(graph_.input_count(), request.input_slots[j]));
    for (std::size_t i = 0; i < size; ++i) {
      matrix[i * size + j] = change[request.input_slots[i]];
      if (!plan.is_direct[i]) matrix[j * size + i] = matrix[i * size + j];
    }
  }
  return matrix;
}

bool DualNumbers::is_whole(PointDuals const &point, DerivativeRequest const &request, Vector const &matrix,
                           Vector const &weights) const {
  std::size_t const columns = request.input_slots.size(), rows = matrix.size() / columns;
  std::vector<double> const numbers = some_direction(columns);
  Vector const direction = scattered(graph_.input_count(), request.input_slots, numbers);
  Vector const product = is_hessian(request) ? point.second(weights, direction) : point.forward(direction);
  std::vector<std::uint32_t> const &slots = is_hessian(request) ? request.input_slots : request.output_slots;
  for (std::size_t i = 0; i < rows; ++i) {
    long double sum = 0, magnitude = std::abs(product[slots[i]]);
    for (std::size_t j = 0; j < columns; ++j) {
      long double const part = matrix[i * columns + j] * static_cast<long double>(numbers[j]);
      sum += part, magnitude += std::abs(part);
    }
    // Rows with an infinity or a NaN are inconclusive.
    if (std::isfinite(magnitude) && std::abs(sum - product[slots[i]]) > most_off_product * magnitude) return false;
  }
  return true;
}

Vector DualNumbers::matrix_of(PointDuals const &point, DerivativeRequest const &request, Plan const &plan,
                              Vector const &weights) const {
  return is_hessian(request) ? hessian(point, request, plan, weights) : jacobian(point, request, plan);
}

Vector DualNumbers::at(std::span<std::span<double const> const> seeds, std::span<double const> inputs,
                       std::span<double const> parameters) const {
  PointDuals const point(graph_, inputs, parameters, std::ranges::any_of(requests_, is_hessian) ? 2 : 1, call_);
  std::size_t const from = graph_.input_count(), to = graph_.output_count();
  Vector result;
  for (std::size_t k = 0; k < requests_.size(); ++k) {
    DerivativeRequest const &request = requests_[k];
    std::vector<std::uint32_t> const &outputs = request.output_slots, &columns = request.input_slots;
    if (is_by_elements(request)) {
      Vector const weights = request.is_weighted ? scattered(to, outputs, seeds[k]) : unit(to, outputs[0]);
      Vector matrix = matrix_of(point, request, plans_[k], weights);
      if (!is_whole(point, request, matrix, weights))
        matrix = matrix_of(point, request, without_structure(request), weights);
      result.insert(result.end(), matrix.begin(), matrix.end());
    } else if (request.kind == DerivativeKind::jvp)
      add_picked(point.forward(scattered(from, columns, seeds[k])), outputs, result);
    else
      add_picked(point.reverse(scattered(to, outputs, seeds[k])), columns, result);
  }
  return result;
}

} // namespace symreal
