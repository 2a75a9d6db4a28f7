#include "differentiate/differences.h"

#include "graph/extended.h"

#include <algorithm>
#include <cmath>

namespace symreal {

namespace {

using Vector = PointDifferences::Vector;
using SharpVector = std::vector<SharpNumber>;

constexpr long double most_cancelled = 4; // times the result

Vector unit(PointDifferences const &point, std::uint32_t slot, long double length) {
  Vector direction(point.input_count(), 0);
  direction[slot] = length;
  return direction;
}

SharpNumber sum(SharpNumber const &a, SharpNumber const &b, long double factor) {
  return a && b ? SharpNumber(*a + factor * *b) : std::nullopt;
}

// By the first derivatives by each input: one or several outputs.
void add_columns(DerivativeRequest const &request, PointDifferences const &point, SharpVector &result) {
  std::vector<SharpVector> columns;
  for (std::uint32_t const slot : request.input_slots) columns.push_back(point.along(unit(point, slot, 1), 1));
  for (std::uint32_t const row : request.output_slots)
    for (SharpVector const &column : columns) result.push_back(column[row]);
}

SharpNumber weighted(DerivativeRequest const &request, SharpVector const &all, std::span<double const> weights) {
  SharpNumber result = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) result = sum(result, all[request.output_slots[i]], weights[i]);
  return result;
}

// What u + v has more than u and v, unless these are so large that the rest is not sharp.
SharpNumber mixed(SharpNumber const &whole, SharpNumber const &one, SharpNumber const &other, long double scale) {
  if (!whole || !one || !other) return {};
  long double const rest = *whole - *one - *other;
  long double const parts = std::max({std::abs(*whole), std::abs(*one), std::abs(*other)});
  return parts > most_cancelled * std::max(scale, std::abs(rest)) ? std::nullopt : SharpNumber(rest);
}

// Of directions u and v the derivative is half of what u + v has more than both.
void add_hessian(DerivativeRequest const &request, PointDifferences const &point, std::span<double const> weights,
                 SharpVector &result) {
  std::vector<std::uint32_t> const &slots = request.input_slots;
  auto const along = [&](Vector const &direction) {
    SharpVector const all = point.along(direction, 2);
    return request.is_weighted ? weighted(request, all, weights) : all[request.output_slots[0]];
  };
  std::vector<SharpNumber> diagonal;
  for (std::uint32_t const slot : slots) diagonal.push_back(along(unit(point, slot, point.scale(slot))));
  std::size_t const first = result.size(), count = slots.size();
  result.resize(first + count * count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      long double const scales = point.scale(slots[i]) * point.scale(slots[j]);
      SharpNumber element = diagonal[i];
      if (i != j) {
        Vector both = unit(point, slots[i], point.scale(slots[i]));
        both[slots[j]] = point.scale(slots[j]);
        element = mixed(along(both), diagonal[i], diagonal[j], 2 * scales);
      }
      if (element) *element /= i == j ? scales : 2 * scales;
      result[first + i * count + j] = result[first + j * count + i] = element;
    }
}

void add_jvp(DerivativeRequest const &request, PointDifferences const &point, std::span<double const> seeds,
             SharpVector &result) {
  Vector direction(point.input_count(), 0);
  for (std::size_t j = 0; j < seeds.size(); ++j) direction[request.input_slots[j]] = seeds[j];
  SharpVector const all = point.along(direction, 1);
  for (std::uint32_t const row : request.output_slots) result.push_back(all[row]);
}

void add_vjp(DerivativeRequest const &request, PointDifferences const &point, std::span<double const> seeds,
             SharpVector &result) {
  for (std::uint32_t const slot : request.input_slots)
    result.push_back(weighted(request, point.along(unit(point, slot, 1), 1), seeds));
}

} // namespace

Differences::Differences(Graph const &graph, std::span<DerivativeWish const> wishes, CallExternal call)
    : graph_(graph),
      call_(std::move(call)),
      obstacle_(obstacle_to_extended(graph, static_cast<bool>(call_))) {
  for (DerivativeWish const &wish : wishes) {
    DerivativeRequest const &request = requests_.emplace_back(read_request(wish, graph));
    std::size_t first = seed_count_;
    for (std::size_t k = 0; k + 1 < requests_.size(); ++k)
      if (requests_[k].seed_count() > 0 && requests_[k].seed_label() == request.seed_label()) first = first_seed_[k];
    first_seed_.push_back(first);
    seed_count_ = std::max(seed_count_, first + request.seed_count());
  }
}

std::size_t Differences::evaluations() const {
  std::size_t directions = 0;
  for (DerivativeRequest const &request : requests_) {
    std::size_t const columns = request.input_slots.size();
    if (request.kind == DerivativeKind::jvp)
      ++directions;
    else
      directions += request.kind == DerivativeKind::hessian ? columns * (columns + 1) / 2 : columns;
  }
  return PointDifferences::evaluations * directions;
}

std::vector<std::span<double const>> Differences::seeds_of_requests(std::span<double const> seeds) const {
  std::vector<std::span<double const>> result;
  for (std::size_t k = 0; k < requests_.size(); ++k)
    result.push_back(seeds.subspan(first_seed_[k], requests_[k].seed_count()));
  return result;
}

std::vector<SharpNumber> Differences::at(std::span<double const> inputs, std::span<double const> parameters,
                                         double tolerance) const {
  internal_check(obstacle_.empty() && inputs.size() == graph_.input_count() + seed_count());
  PointDifferences const point(graph_, inputs.first(graph_.input_count()), parameters, tolerance, call_);
  auto const seeds = seeds_of_requests(inputs.subspan(graph_.input_count()));
  SharpVector result;
  for (std::size_t k = 0; k < requests_.size(); ++k) {
    DerivativeRequest const &request = requests_[k];
    std::span<double const> const own = seeds[k];
    switch (request.kind) {
    case DerivativeKind::jacobian:
    case DerivativeKind::gradient: add_columns(request, point, result); break;
    case DerivativeKind::hessian: add_hessian(request, point, own, result); break;
    case DerivativeKind::jvp: add_jvp(request, point, own, result); break;
    case DerivativeKind::vjp: add_vjp(request, point, own, result); break;
    }
  }
  return result;
}

} // namespace symreal
