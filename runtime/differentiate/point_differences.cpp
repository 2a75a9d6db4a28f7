#include "differentiate/point_differences.h"

#include "graph/evaluate.h"
#include "graph/extended.h"

#include <algorithm>
#include <cmath>

namespace symreal {

namespace {

using Vector = PointDifferences::Vector;

constexpr int levels = 8;             // steps, each a quarter of the one before
constexpr int perturbations = 3;      // on each side
constexpr long double most_noise = 4; // times the largest that is seen
constexpr long double unknown = std::numeric_limits<long double>::infinity();

// Extrapolation of one number whose error has even powers of the step alone: Ridders' method. An estimate of the error
// may be small by accident, so two levels must agree.
class Extrapolation {
public:
  // `noise`: how far rounding may have moved the value. Numbers that agree because no step shows tell nothing.
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

std::size_t const PointDifferences::evaluations = 2 * std::size_t{levels + perturbations};

PointDifferences::PointDifferences(Graph const &graph, std::span<double const> inputs,
                                   std::span<double const> parameters, double tolerance)
    : graph_(graph),
      inputs_(inputs.begin(), inputs.end()),
      parameters_(parameters),
      tolerance_(tolerance / 16),
      values_(evaluate(graph, inputs, parameters)),
      middle_(evaluate_extended(graph, std::span<long double const>(inputs_), parameters, values_).value_or(Vector())) {
}

std::vector<SharpNumber> PointDifferences::along(Vector const &direction, int order) const {
  std::size_t const count = graph_.results.size();
  std::vector<Extrapolation> numbers(count);
  std::vector<char> has_kink(count, 0);
  Vector bends(count, 0);
  std::vector<Neighbours> const neighbours = neighbours_along(direction);
  Vector const noise = neighbours.empty() ? Vector() : noise_beside(direction, neighbours.front());
  for (Neighbours const &pair : neighbours) {
    if (!pair.are_finite()) {
      std::ranges::fill(numbers, Extrapolation());
      continue;
    }
    long double const step = pair.step;
    for (std::size_t k = 0; k < count; ++k) {
      long double const high = pair.high[k], low = pair.low[k];
      long double const second = high - 2 * middle_[k] + low;
      if (order == 1)
        numbers[k].add((high - low) / (2 * step), noise[k] / step);
      else
        numbers[k].add(second / (step * step), 4 * noise[k] / (step * step));
      // What bends is bent less by a quarter of the step; a kink is as sharp as before.
      long double const bend = std::abs(second) / step;
      has_kink[k] = bend > tolerance_ && 2 * bend > bends[k] && &pair != neighbours.data();
      bends[k] = bend;
    }
  }
  std::vector<SharpNumber> result;
  for (std::size_t k = 0; k < count; ++k)
    result.push_back(order == 1 && has_kink[k] ? std::nullopt : numbers[k].result(tolerance_));
  return result;
}

long double PointDifferences::scale(std::uint32_t slot) const { return std::max(1.0L, std::abs(inputs_[slot])); }

bool PointDifferences::Neighbours::are_finite() const {
  auto const is_finite = [](long double number) { return std::isfinite(number); };
  return !high.empty() && !low.empty() && std::ranges::all_of(high, is_finite) && std::ranges::all_of(low, is_finite);
}

long double PointDifferences::first_step(Vector const &direction) const {
  long double most = 0;
  for (std::uint32_t slot = 0; slot < direction.size(); ++slot)
    most = std::max(most, std::abs(direction[slot]) / scale(slot));
  return most == 0 ? 1 : 0x1p-4L / most;
}

std::vector<PointDifferences::Neighbours> PointDifferences::neighbours_along(Vector const &direction) const {
  std::vector<Neighbours> all;
  long double step = first_step(direction);
  for (int level = 0; !middle_.empty() && level < levels; ++level, step /= 4)
    all.push_back({step, moved(direction, step), moved(direction, -step)});
  return all;
}

Vector PointDifferences::moved(Vector const &direction, long double step, std::uint64_t perturbation) const {
  Vector at = inputs_;
  for (std::size_t k = 0; k < at.size(); ++k) at[k] += step * direction[k];
  return evaluate_extended(graph_, std::span<long double const>(at), parameters_, values_, perturbation)
      .value_or(Vector());
}

// How far rounding moves each output, from results that are moved by as much.
Vector PointDifferences::noise_beside(Vector const &direction, Neighbours const &pair) const {
  Vector noise(graph_.results.size(), 0);
  for (auto const &[side, step] : {std::pair(&pair.high, pair.step), std::pair(&pair.low, -pair.step)})
    for (std::uint64_t perturbation = 1; perturbation <= perturbations; ++perturbation) {
      Vector const other = moved(direction, step, perturbation);
      for (std::size_t k = 0; k < noise.size(); ++k) {
        long double const seen =
            side->empty() || other.empty() ? unknown : most_noise * std::abs(other[k] - (*side)[k]);
        noise[k] = seen <= noise[k] ? noise[k] : std::isnan(seen) ? unknown : seen;
      }
    }
  return noise;
}

} // namespace symreal
