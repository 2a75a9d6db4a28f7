#include "engine/optimise/differentiate/dual_numbers.h"

#include "engine/graph/extended.h"
#include "engine/optimise/differentiate/rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace symreal {

namespace {

using Vector = DualNumbers::Vector;

struct Dual {
  long double value = 0, slope = 0;
};
using Duals = std::array<Dual, 4>; // the operands, then the result

// Product in which 0 absorbs infinities, as in the arm of a select that is not taken.
long double times(long double a, long double b) { return a == 0 || b == 0 ? 0 : a * b; }

Dual evaluate_dual(Op op, Duals const &operands);

Dual evaluate_dual(Term const &term, Duals const &duals) {
  switch (term.kind) {
  case Term::Kind::number: return {term.number, 0};
  case Term::Kind::variable: return duals[term.variable == 'r' ? 3 : static_cast<std::size_t>(term.variable - 'x')];
  case Term::Kind::operation: break;
  }
  Duals operands;
  for (std::size_t i = 0; i < term.operands.size(); ++i) operands[i] = evaluate_dual(term.operands[i], duals);
  return evaluate_dual(term.op, operands);
}

// Recursion is shallow: terms of the operation table are a few levels deep.
Dual evaluate_dual(Op op, Duals const &operands) {
  Dual result{evaluate_extended(op, operands[0].value, operands[1].value, operands[2].value), 0};
  Duals plain;
  for (std::size_t i = 0; i < 3; ++i) plain[i].value = operands[i].value;
  plain[3].value = result.value;
  for (std::size_t i = 0; i < arity(op); ++i)
    if (operands[i].slope != 0 && slope_of(op, i) == Slope::formula)
      result.slope += times(evaluate_dual(derivative_of(op, i), plain).value, operands[i].slope);
  return result;
}

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

// Numeric derivatives at one point in extended precision: each node of the recorded graph carries its value and slopes.
class PointDuals {
public:
  // Extended precision can evaluate `graph`, which outlives this object. `order` of the derivatives is 1 or 2.
  PointDuals(Graph const &graph, std::span<double const> inputs, std::span<double const> parameters, int order,
             CallExternal const &call)
      : graph_(graph),
        value_(graph.nodes.size(), 0),
        slope_(graph.nodes.size()) {
    CallResults calls(graph, call);
    auto const results = [&](NodeId of, std::size_t function) -> std::vector<double> & {
      return calls.of(of, function, [&](NodeId argument) { return static_cast<double>(value_[argument]); });
    };
    for (std::size_t id = 0; id < value_.size(); ++id) {
      Node const &node = graph.nodes[id];
      if (node.op == Op::constant) value_[id] = node.value();
      if (node.op == Op::input) value_[id] = inputs[node.slot()];
      if (node.op == Op::parameter) value_[id] = parameters[node.slot()];
      if (node.op == Op::returned) {
        NodeId const called = node.operand[0];
        std::size_t const function = function_of(graph, graph.nodes[called]);
        value_[id] = results(called, function)[result_of(graph, node)];
        CallSlopes slopes{differentiable_arguments(graph, static_cast<NodeId>(id)), {}, {}};
        std::size_t const count = slopes.arguments.size();
        if (count == 0) continue;
        std::size_t const first = first_partial(graph, static_cast<NodeId>(id));
        std::size_t const derivative = derivative_function(graph, function);
        auto const take = [](std::vector<double> const &all, std::size_t from, std::size_t number) {
          auto const begin = all.begin() + static_cast<std::ptrdiff_t>(from);
          return Vector(begin, begin + static_cast<std::ptrdiff_t>(number));
        };
        slopes.first = take(results(called, derivative), first, count);
        if (std::size_t const second = derivative_function(graph, derivative); second != graph.externals.size())
          slopes.second = take(results(called, second), first * count, count * count);
        call_slopes_.emplace(static_cast<NodeId>(id), std::move(slopes));
        continue;
      }
      if (is_leaf(node.op) || node.op == Op::argument || node.op == Op::call) continue;
      Duals duals;
      for (std::size_t i = 0; i < arity(node.op); ++i) duals[i].value = value_[node.operand[i]];
      duals[3].value = value_[id] = evaluate_extended(node.op, duals[0].value, duals[1].value, duals[2].value);
      for (std::size_t i = 0; i < arity(node.op); ++i)
        if (slope_of(node.op, i) == Slope::formula)
          slope_[id][i] = evaluate_dual(derivative_of(node.op, i), duals).value;
      if (order > 1) add_curvature(static_cast<NodeId>(id));
    }
  }

  // Slopes of all outputs along a direction of the inputs.
  Vector forward(Vector const &direction) const {
    Vector const tangent = tangents(direction);
    Vector result;
    for (NodeId const output : graph_.results) result.push_back(tangent[output]);
    return result;
  }

  // Slopes of the weighted sum of the outputs by all inputs, and their change along a direction.
  Vector reverse(Vector const &weights) const {
    Vector adjoint(value_.size(), 0), result(graph_.input_count(), 0);
    for (std::size_t k = 0; k < weights.size(); ++k) adjoint[graph_.results[k]] += weights[k];
    for (std::size_t id = adjoint.size(); id-- > 0;) {
      Node const &node = graph_.nodes[id];
      if (node.op == Op::input) result[node.slot()] += adjoint[id];
      if (is_leaf(node.op) || adjoint[id] == 0) continue;
      for_each_slope(id, [&](NodeId operand, long double slope) { adjoint[operand] += times(slope, adjoint[id]); });
    }
    return result;
  }

  Vector second(Vector const &weights, Vector const &direction) const {
    Vector const tangent = tangents(direction);
    std::vector<Dual> adjoint(value_.size());
    Vector result(graph_.input_count(), 0);
    for (std::size_t k = 0; k < weights.size(); ++k) adjoint[graph_.results[k]].value += weights[k];
    auto bent = curvatures_.rbegin();
    for (std::size_t id = adjoint.size(); id-- > 0;) {
      Node const &node = graph_.nodes[id];
      while (bent != curvatures_.rend() && bent->node > id) ++bent;
      auto const [weight, change] = adjoint[id];
      if (node.op == Op::input) result[node.slot()] += change;
      if (is_leaf(node.op) || (weight == 0 && change == 0)) continue;
      if (auto const found = call_slopes_.find(static_cast<NodeId>(id)); found != call_slopes_.end()) {
        auto const &[arguments, first, second] = found->second;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
          Dual &sum = adjoint[arguments[i]];
          sum.value += times(weight, first[i]);
          sum.slope += times(change, first[i]);
          for (std::size_t j = 0; j < arguments.size() && !second.empty(); ++j)
            sum.slope += times(weight, times(second[i * arguments.size() + j], tangent[arguments[j]]));
        }
        continue;
      }
      bool const is_bent = bent != curvatures_.rend() && bent->node == id;
      for (std::size_t i = 0; i < arity(node.op); ++i) {
        Dual &sum = adjoint[node.operand[i]];
        sum.value += times(weight, slope_[id][i]);
        sum.slope += times(change, slope_[id][i]);
        for (std::size_t j = 0; is_bent && j < arity(node.op); ++j)
          sum.slope += times(weight, times(bent->by[i][j], tangent[node.operand[j]]));
      }
    }
    return result;
  }

private:
  // Slopes of a differentiable call's result by the numeric arguments, and the change of these by each argument; the
  // latter is empty if the derivative has no derivative.
  struct CallSlopes {
    std::vector<NodeId> arguments;
    Vector first, second;
  };

  // Change of an operation's slopes by each operand.
  struct Curvature {
    NodeId node;
    std::array<std::array<long double, 3>, 3> by;
  };

  void add_curvature(NodeId id) {
    Node const &node = graph_.nodes[id];
    if (node.op == Op::add || node.op == Op::sub || node.op == Op::neg) return;
    Curvature curvature{id, {}};
    bool is_bent = false;
    for (std::size_t j = 0; j < arity(node.op); ++j) {
      Duals duals;
      for (std::size_t i = 0; i < arity(node.op); ++i) duals[i] = {value_[node.operand[i]], i == j ? 1.0L : 0.0L};
      duals[3] = {value_[id], slope_[id][j]};
      for (std::size_t i = 0; i < arity(node.op); ++i) {
        if (slope_of(node.op, i) != Slope::formula) continue;
        curvature.by[i][j] = evaluate_dual(derivative_of(node.op, i), duals).slope;
        is_bent |= curvature.by[i][j] != 0;
      }
    }
    if (is_bent) curvatures_.push_back(curvature);
  }

  // Calls `use(operand, slope)` for the operands of an operation, or the numeric arguments of a call.
  template <class Use> void for_each_slope(std::size_t id, Use const &use) const {
    Node const &node = graph_.nodes[id];
    for (std::size_t i = 0; i < arity(node.op); ++i) use(node.operand[i], slope_[id][i]);
    if (auto const found = call_slopes_.find(static_cast<NodeId>(id)); found != call_slopes_.end())
      for (std::size_t i = 0; i < found->second.arguments.size(); ++i)
        use(found->second.arguments[i], found->second.first[i]);
  }

  Vector tangents(Vector const &direction) const {
    Vector tangent(value_.size(), 0);
    for (std::size_t id = 0; id < tangent.size(); ++id) {
      Node const &node = graph_.nodes[id];
      if (node.op == Op::input) tangent[id] = direction[node.slot()];
      if (is_leaf(node.op)) continue;
      for_each_slope(id, [&](NodeId operand, long double slope) { tangent[id] += times(slope, tangent[operand]); });
    }
    return tangent;
  }

  Graph const &graph_;
  Vector value_;                                  // per node
  std::vector<std::array<long double, 3>> slope_; // per node, by each operand
  std::vector<Curvature> curvatures_;             // of the nonlinear nodes, ascending
  std::map<NodeId, CallSlopes> call_slopes_;
};

DualNumbers::DualNumbers(Graph const &graph, std::vector<DerivativeRequest> requests, CallExternal call)
    : graph_(graph),
      requests_(std::move(requests)),
      call_(std::move(call)) {
  for (DerivativeRequest const &request : requests_)
    compressions_.push_back(is_by_elements(request) ? compression_of(request) : Compression());
}

DualNumbers::Compression DualNumbers::compression_of(DerivativeRequest const &request) const {
  std::vector<std::uint32_t> position(graph_.input_count(), Colouring::none);
  for (std::size_t j = 0; j < request.input_slots.size(); ++j)
    position[request.input_slots[j]] = static_cast<std::uint32_t>(j);
  std::vector<NodeId> outputs;
  for (std::uint32_t const slot : request.output_slots) outputs.push_back(graph_.results[slot]);
  Pattern const all = is_hessian(request) ? coupled_inputs(graph_, outputs) : inputs_of(graph_, outputs);
  Compression compression;
  compression.rows.resize(is_hessian(request) ? request.input_slots.size() : outputs.size());
  for (std::size_t i = 0; i < compression.rows.size(); ++i)
    for (std::uint32_t const slot : all[is_hessian(request) ? request.input_slots[i] : i])
      if (position[slot] != Colouring::none) compression.rows[i].push_back(position[slot]);
  for (auto &row : compression.rows) std::ranges::sort(row);
  compression.is_direct = direct_rows(compression.rows);
  Pattern together = compression.rows;
  for (std::size_t i = 0; i < together.size(); ++i) {
    if (compression.is_direct[i]) together[i].clear();
    if (is_hessian(request)) std::erase_if(together[i], [&](std::uint32_t j) { return compression.is_direct[j] != 0; });
  }
  compression.colours = coloured(together, request.input_slots.size());
  return compression;
}

DualNumbers::Compression DualNumbers::without_structure(DerivativeRequest const &request) {
  std::size_t const rows = is_hessian(request) ? request.input_slots.size() : request.output_slots.size();
  return {Pattern(rows), {std::vector(request.input_slots.size(), Colouring::none), 0}, std::vector<char>(rows, 1)};
}

std::size_t DualNumbers::passes() const {
  std::size_t count = 0;
  for (Compression const &compression : compressions_)
    count += 1 + compression.colours.count + static_cast<std::size_t>(std::ranges::count(compression.is_direct, 1));
  return count;
}

Vector DualNumbers::jacobian(PointDuals const &point, DerivativeRequest const &request,
                             Compression const &compression) const {
  std::size_t const rows = request.output_slots.size(), columns = request.input_slots.size();
  Vector matrix(rows * columns, 0);
  for (std::size_t i = 0; i < rows; ++i) {
    if (!compression.is_direct[i]) continue;
    Vector const row = point.reverse(unit(graph_.output_count(), request.output_slots[i]));
    for (std::size_t j = 0; j < columns; ++j) matrix[i * columns + j] = row[request.input_slots[j]];
  }
  for (std::uint32_t colour = 0; colour < compression.colours.count; ++colour) {
    Vector direction(graph_.input_count(), 0);
    for (std::size_t j = 0; j < columns; ++j)
      if (compression.colours.colour[j] == colour) direction[request.input_slots[j]] = 1;
    Vector const slopes = point.forward(direction);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::uint32_t const j : compression.rows[i])
        if (!compression.is_direct[i] && compression.colours.colour[j] == colour)
          matrix[i * columns + j] = slopes[request.output_slots[i]];
  }
  return matrix;
}

// Each direct row is copied to its column by symmetry.
Vector DualNumbers::hessian(PointDuals const &point, DerivativeRequest const &request, Compression const &compression,
                            Vector const &weights) const {
  std::size_t const size = request.input_slots.size();
  Vector matrix(size * size, 0);
  for (std::uint32_t colour = 0; colour < compression.colours.count; ++colour) {
    Vector direction(graph_.input_count(), 0);
    for (std::size_t j = 0; j < size; ++j)
      if (compression.colours.colour[j] == colour) direction[request.input_slots[j]] = 1;
    Vector const change = point.second(weights, direction);
    for (std::size_t i = 0; i < size; ++i)
      for (std::uint32_t const j : compression.rows[i])
        if (!compression.is_direct[i] && compression.colours.colour[j] == colour)
          matrix[i * size + j] = change[request.input_slots[i]];
  }
  for (std::size_t j = 0; j < size; ++j) {
    if (!compression.is_direct[j]) continue;
    Vector const change = point.second(weights, unit(graph_.input_count(), request.input_slots[j]));
    for (std::size_t i = 0; i < size; ++i) {
      matrix[i * size + j] = change[request.input_slots[i]];
      if (!compression.is_direct[i]) matrix[j * size + i] = matrix[i * size + j];
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

Vector DualNumbers::matrix_of(PointDuals const &point, DerivativeRequest const &request, Compression const &compression,
                              Vector const &weights) const {
  return is_hessian(request) ? hessian(point, request, compression, weights) : jacobian(point, request, compression);
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
      Vector matrix = matrix_of(point, request, compressions_[k], weights);
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
