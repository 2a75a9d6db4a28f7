#include "engine/optimise/differentiate/point_differences.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace symreal {

namespace {

using Vector = PointDifferences::Vector;

constexpr int levels = 8;                         // steps, each a quarter of the previous one
constexpr int probes[] = {9, 11, 12, 13, 15, 17}; // levels of the smaller steps that must confirm a result
constexpr long double doubtful = 8;               // times its noise: deviation at which one of the many probes rejects
constexpr long double telling =
    0.1L;                        // noise, relative to the larger of the result and 1, with which a probe still confirms
constexpr int perturbations = 3; // per side
constexpr long double most_noise = 4; // times the largest observed
constexpr long double unknown = std::numeric_limits<long double>::infinity();

// Ridders' extrapolation of a number whose error has only even powers of the step. As a small error estimate may be
// accidental, two levels must agree.
class Extrapolation {
public:
  // `noise` bounds the rounding error of the value. Values that agree because the step is invisible prove nothing.
  void add(long double value, long double noise) {
    std::vector<long double> row = {value};
    Estimate level;
    long double factor = 1;
    for (std::size_t j = 0; j < last_.size(); ++j) {
      factor *= 16;
      row.push_back((factor * row[j] - last_[j]) / (factor - 1));
      long double const error = std::max({std::abs(row[j + 1] - row[j]), std::abs(row[j + 1] - last_[j]), noise});
      if (error <= level.error) level = {row[j + 1], error};
    }
    last_ = std::move(row);
    if (level.error <= best_.error) std::swap(level, best_);
    if (level.error <= second_.error) second_ = level;
  }
  SharpNumber result(long double tolerance) const {
    long double const error = std::max({best_.error, second_.error, std::abs(best_.value - second_.value)});
    bool const is_sharp = error <= tolerance * std::max(1.0L, std::abs(best_.value));
    return is_sharp ? SharpNumber(best_.value) : std::nullopt;
  }

private:
  struct Estimate {
    long double value = 0, error = unknown;
  };
  std::vector<long double> last_;
  Estimate best_, second_;
};

} // namespace

std::size_t const PointDifferences::evaluations = 2 * (levels + perturbations + std::size(probes));

PointDifferences::PointDifferences(Graph const &graph, std::vector<NodeId> const &nodes, std::span<double const> inputs,
                                   std::span<double const> parameters, double tolerance, CallExternal const &call)
    : inputs_(inputs.begin(), inputs.end()),
      tolerance_(tolerance / 16),
      neighbourhood_(graph, nodes, parameters, evaluate(graph, inputs, parameters, call), call),
      middle_(neighbourhood_.at(inputs_)) {}

std::vector<SharpNumber> PointDifferences::along(Vector const &direction, int order) const {
  std::vector<Neighbours> const neighbours = neighbours_along(direction);
  Vector const noise = noise_beside(direction, neighbours.front());
  std::vector<SharpNumber> result;
  for (std::size_t k = 0; k < middle_.size(); ++k) result.push_back(sharp(neighbours, noise, k, order));
  return result;
}

SharpNumber PointDifferences::sharp(std::vector<Neighbours> const &neighbours, Vector const &noise, std::size_t node,
                                    int order) const {
  if (!std::isfinite(middle_[node])) return {};
  Extrapolation number;
  std::vector<Quotient> smaller;
  bool has_kink = false;
  long double bend = 0, last = unknown;
  for (std::size_t level = 0; level < neighbours.size(); ++level) {
    Neighbours const &pair = neighbours[level];
    if (!pair.are_finite(node)) {
      number = Extrapolation();
      continue;
    }
    Quotient const found = quotient(pair, noise, node, order);
    if (level >= levels) {
      smaller.push_back(found);
      continue;
    }
    number.add(found.value, found.noise);
    last = found.value;
    // A quarter of the step lessens a smooth bend, not a kink.
    long double const before = std::exchange(bend, std::abs(bend_of(pair, node)) / pair.step);
    has_kink = bend > tolerance_ && 2 * bend > before && level != 0;
  }
  SharpNumber const result = order == 1 && has_kink ? std::nullopt : number.result(tolerance_of(order));
  return result && is_confirmed(smaller, *result, last, tolerance_of(order)) ? result : std::nullopt;
}

long double PointDifferences::bend_of(Neighbours const &pair, std::size_t node) const {
  return pair.high[node] - 2 * middle_[node] + pair.low[node];
}

PointDifferences::Quotient PointDifferences::quotient(Neighbours const &pair, Vector const &noise, std::size_t node,
                                                      int order) const {
  long double const step = pair.step;
  if (order == 1) return {(pair.high[node] - pair.low[node]) / (2 * step), noise[node] / step};
  return {bend_of(pair, node) / (step * step), 4 * noise[node] / (step * step)};
}

bool PointDifferences::is_confirmed(std::vector<Quotient> const &smaller, long double result, long double last,
                                    long double tolerance) {
  long double const scale = std::max(1.0L, std::abs(result));
  bool is_told = false;
  for (auto const &[value, noise] : smaller) {
    if (!(std::abs(value - result) <= std::abs(last - result) + doubtful * noise + tolerance * scale)) return false;
    is_told |= noise <= telling * scale;
  }
  return is_told;
}

// A power of two, which keeps most sums with steps exact.
long double PointDifferences::scale(std::uint32_t slot) const {
  return std::exp2(std::floor(std::log2(std::max(1.0L, std::abs(inputs_[slot])))));
}

bool PointDifferences::Neighbours::are_finite(std::size_t node) const {
  return std::isfinite(high[node]) && std::isfinite(low[node]);
}

long double PointDifferences::first_step(Vector const &direction) const {
  long double most = 0;
  for (std::uint32_t slot = 0; slot < direction.size(); ++slot)
    most = std::max(most, std::abs(direction[slot]) / scale(slot));
  return most == 0 ? 1 : std::exp2(std::floor(std::log2(0x1p-4L / most))); // keeps most sums exact
}

std::vector<PointDifferences::Neighbours> PointDifferences::neighbours_along(Vector const &direction) const {
  std::vector<Neighbours> all;
  long double const step = first_step(direction);
  auto const add = [&](long double size) { all.push_back({size, moved(direction, size), moved(direction, -size)}); };
  for (int level = 0; level < levels; ++level) add(std::ldexp(step, -2 * level));
  for (int const level : probes) add(std::ldexp(step, -2 * level));
  return all;
}

Vector PointDifferences::moved(Vector const &direction, long double step, std::uint64_t perturbation) const {
  Vector at = inputs_;
  for (std::size_t k = 0; k < at.size(); ++k) {
    long double const change = step * direction[k];
    at[k] += change;
    if (perturbation != 0 && at[k] - inputs_[k] != change)
      at[k] = std::nextafter(at[k], perturbation % 2 == 0 ? 0 : 2 * at[k]);
  }
  return neighbourhood_.at(at, perturbation);
}

// Rounding noise of each node, estimated from evaluations with perturbed intermediate results.
Vector PointDifferences::noise_beside(Vector const &direction, Neighbours const &pair) const {
  Vector noise(middle_.size(), 0);
  for (auto const &[side, step] : {std::pair(&pair.high, pair.step), std::pair(&pair.low, -pair.step)})
    for (std::uint64_t perturbation = 1; perturbation <= perturbations; ++perturbation) {
      Vector const other = moved(direction, step, perturbation);
      for (std::size_t k = 0; k < noise.size(); ++k) {
        long double const seen = most_noise * std::abs(other[k] - (*side)[k]);
        noise[k] = seen <= noise[k] ? noise[k] : std::isnan(seen) ? unknown : seen;
      }
    }
  return noise;
}

} // namespace symreal
