#include "engine/optimise/differentiate/differences.h"

#include "engine/graph/extended.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace symreal {

namespace {

using Vector = PointDifferences::Vector;

constexpr long double most_cancelled = 4;      // times the result
constexpr std::size_t most_divided = 4;        // addends that share the tolerance; more do not add up
constexpr long double most_cancelled_sum = 16; // times the sum; each addend has 1/16 of the tolerance

// The mixed part of a second difference, whole - one - other; nullopt if it cancels too much to be sharp.
SharpNumber mixed(SharpNumber const &whole, SharpNumber const &one, SharpNumber const &other, long double scale) {
  if (!whole || !one || !other) return {};
  long double const rest = *whole - *one - *other;
  long double const parts = std::max({std::abs(*whole), std::abs(*one), std::abs(*other)});
  return parts > most_cancelled * std::max(scale, std::abs(rest)) ? std::nullopt : SharpNumber(rest);
}

// Weighted sum; sharp if all its addends are sharp and do not cancel.
class SharpSum {
public:
  void add(SharpNumber const &number, long double factor) {
    is_sharp_ &= number.has_value();
    if (!number) return;
    sum_ += factor * *number;
    largest_ = std::max(largest_, std::abs(factor * *number));
    ++count_;
  }
  SharpNumber result() const {
    bool const cancels = count_ > 1 && largest_ > most_cancelled_sum * std::max(1.0L, std::abs(sum_));
    return is_sharp_ && !cancels ? SharpNumber(sum_) : std::nullopt;
  }

private:
  long double sum_ = 0, largest_ = 0;
  std::size_t count_ = 0;
  bool is_sharp_ = true;
};

// Direction that moves all inputs of some colours, each by its scale.
Vector direction_of(PointDifferences const &point, Colouring const &colours,
                    std::initializer_list<std::uint32_t> moved) {
  Vector direction(point.input_count(), 0);
  for (std::uint32_t slot = 0; slot < direction.size(); ++slot)
    if (std::ranges::find(moved, colours.colour[slot]) != moved.end()) direction[slot] = point.scale(slot);
  return direction;
}

// Factor of each term in the differentiated output or weighted sum of outputs.
std::vector<long double> factors_of(DerivativeRequest const &request, Addends const &addends,
                                    std::span<double const> weights) {
  std::vector<long double> factors(addends.terms().size(), 0);
  for (std::size_t i = 0; i < request.output_slots.size(); ++i)
    for (auto const &[term, factor] : addends.of(request.output_slots[i]))
      factors[term] += factor * static_cast<long double>(request.is_weighted ? weights[i] : 1);
  return factors;
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
  if (!obstacle_.empty()) return;
  first_ = directions_of({DerivativeKind::jacobian, DerivativeKind::gradient, DerivativeKind::vjp});
  second_ = directions_of({DerivativeKind::hessian});
  given_ = directions_of({DerivativeKind::jvp});
}

// Directions for the requests of these kinds; nullopt if no request is of these kinds.
std::optional<Differences::Directions> Differences::directions_of(Kinds kinds) const {
  std::vector<std::uint32_t> outputs;
  std::vector<char> is_moved(graph_.input_count(), 0);
  for (DerivativeRequest const &request : requests_) {
    if (std::ranges::find(kinds, request.kind) == kinds.end()) continue;
    outputs.insert(outputs.end(), request.output_slots.begin(), request.output_slots.end());
    for (std::uint32_t const slot : request.input_slots) is_moved[slot] = 1;
  }
  if (outputs.empty()) return {};
  Directions directions{Addends(graph_, std::move(outputs)), {}, {}, {}};
  Pattern rows = directions.addends.inputs();
  for (auto &row : rows) std::erase_if(row, [&](std::uint32_t slot) { return is_moved[slot] == 0; });
  directions.colours = coloured(rows, graph_.input_count());
  std::vector<std::uint32_t> const &colour = directions.colours.colour;
  for (auto const &row : rows) {
    auto &own = directions.input_of.emplace_back();
    for (std::uint32_t const slot : row) {
      own.resize(std::max<std::size_t>(own.size(), colour[slot] + 1), Colouring::none);
      own[colour[slot]] = slot;
    }
  }
  if (std::ranges::find(kinds, DerivativeKind::hessian) == kinds.end()) return directions;
  Pattern const coupled = coupled_inputs(graph_, directions.addends.terms());
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (auto const &row : rows)
    for (std::uint32_t const i : row)
      for (std::uint32_t const j : row)
        if (colour[j] < colour[i] && std::ranges::binary_search(coupled[i], j)) pairs.emplace(colour[i], colour[j]);
  directions.pairs.assign(pairs.begin(), pairs.end());
  return directions;
}

std::size_t Differences::evaluations() const {
  std::size_t count = 0;
  if (first_) count += first_->colours.count;
  if (second_) count += second_->colours.count + second_->pairs.size();
  for (DerivativeRequest const &request : requests_) count += request.kind == DerivativeKind::jvp;
  return PointDifferences::evaluations * count;
}

std::vector<std::span<double const>> Differences::seeds_of_requests(std::span<double const> seeds) const {
  std::vector<std::span<double const>> result;
  for (std::size_t k = 0; k < requests_.size(); ++k)
    result.push_back(seeds.subspan(first_seed_[k], requests_[k].seed_count()));
  return result;
}

PointDifferences Differences::point_of(Directions const &directions, std::span<double const> inputs,
                                       std::span<double const> parameters, double tolerance) const {
  return {graph_,
          directions.addends.terms(),
          inputs,
          parameters,
          tolerance / static_cast<double>(std::min(directions.addends.overlap(), most_divided)),
          call_};
}

SharpNumber Differences::element(Directions const &directions, std::vector<SharpVector> const &columns,
                                 std::uint32_t output, std::uint32_t input) const {
  SharpSum sum;
  std::uint32_t const colour = directions.colours.colour[input];
  for (auto const &[term, factor] : directions.addends.of(output)) {
    auto const &inputs = directions.input_of[term];
    if (colour < inputs.size() && inputs[colour] == input) sum.add(columns[colour][term], factor);
  }
  return sum.result();
}

void Differences::add_first(DerivativeRequest const &request, std::vector<SharpVector> const &columns,
                            std::span<double const> weights, SharpVector &result) const {
  if (request.kind == DerivativeKind::vjp) {
    for (std::uint32_t const input : request.input_slots) {
      SharpSum sum;
      for (std::size_t i = 0; i < weights.size(); ++i)
        sum.add(element(*first_, columns, request.output_slots[i], input), weights[i]);
      result.push_back(sum.result());
    }
    return;
  }
  for (std::uint32_t const output : request.output_slots)
    for (std::uint32_t const input : request.input_slots) result.push_back(element(*first_, columns, output, input));
}

// Hessian elements by polarization: half of what the second difference along u + v exceeds those along u and v. One
// result per request, empty for requests of other kinds.
std::vector<Differences::SharpVector> Differences::hessians(std::span<double const> inputs,
                                                            std::span<double const> parameters,
                                                            std::span<std::span<double const> const> seeds,
                                                            double tolerance) const {
  Directions const &directions = *second_;
  PointDifferences const point = point_of(directions, inputs, parameters, tolerance);
  std::vector<SharpVector> alone;
  for (std::uint32_t colour = 0; colour < directions.colours.count; ++colour)
    alone.push_back(point.along(direction_of(point, directions.colours, {colour}), 2));
  struct Sums {
    std::vector<long double> factors;
    std::vector<std::size_t> position; // of each input slot in the request; its size if absent
    std::vector<SharpSum> elements;
  };
  std::vector<std::optional<Sums>> sums(requests_.size());
  for (std::size_t k = 0; k < requests_.size(); ++k) {
    DerivativeRequest const &request = requests_[k];
    if (request.kind != DerivativeKind::hessian) continue;
    std::size_t const count = request.input_slots.size();
    sums[k] = {factors_of(request, directions.addends, seeds[k]), std::vector<std::size_t>(inputs.size(), count),
               std::vector<SharpSum>(count * count)};
    for (std::size_t i = 0; i < count; ++i) sums[k]->position[request.input_slots[i]] = i;
  }
  auto const add = [&](std::size_t term, std::uint32_t i, std::uint32_t j, SharpNumber const &number) {
    for (std::optional<Sums> &own : sums) {
      if (!own || own->factors[term] == 0) continue;
      std::size_t const row = own->position[i], column = own->position[j];
      std::size_t const count = static_cast<std::size_t>(std::sqrt(static_cast<double>(own->elements.size())));
      if (row == count || column == count) continue;
      own->elements[row * count + column].add(number, own->factors[term]);
      if (row != column) own->elements[column * count + row].add(number, own->factors[term]);
    }
  };
  // Calls `add` with the elements that the differences along one or two colours determine.
  auto const add_all = [&](std::uint32_t one, std::uint32_t other, auto const &number_of) {
    for (std::size_t term = 0; term < directions.input_of.size(); ++term) {
      auto const &own = directions.input_of[term];
      if (std::max(one, other) >= own.size()) continue;
      std::uint32_t const i = own[one], j = own[other];
      if (i != Colouring::none && j != Colouring::none)
        add(term, i, j, number_of(term, point.scale(i) * point.scale(j)));
    }
  };
  for (std::uint32_t colour = 0; colour < directions.colours.count; ++colour)
    add_all(colour, colour, [&](std::size_t term, long double scales) -> SharpNumber {
      SharpNumber const &found = alone[colour][term];
      return found ? SharpNumber(*found / scales) : std::nullopt;
    });
  for (auto const &[one, other] : directions.pairs) {
    SharpVector const both = point.along(direction_of(point, directions.colours, {one, other}), 2);
    add_all(one, other, [&](std::size_t term, long double scales) -> SharpNumber {
      SharpNumber const found = mixed(both[term], alone[one][term], alone[other][term], 2 * scales);
      return found ? SharpNumber(*found / (2 * scales)) : std::nullopt;
    });
  }
  std::vector<SharpVector> results(requests_.size());
  for (std::size_t k = 0; k < requests_.size(); ++k)
    if (sums[k])
      for (SharpSum const &element : sums[k]->elements) results[k].push_back(element.result());
  return results;
}

std::vector<SharpNumber> Differences::at(std::span<double const> inputs, std::span<double const> parameters,
                                         double tolerance) const {
  internal_check(obstacle_.empty() && inputs.size() == graph_.input_count() + seed_count());
  auto const seeds = seeds_of_requests(inputs.subspan(graph_.input_count()));
  inputs = inputs.first(graph_.input_count());
  std::vector<SharpVector> columns, second;
  if (first_) {
    PointDifferences const point = point_of(*first_, inputs, parameters, tolerance);
    for (std::uint32_t colour = 0; colour < first_->colours.count; ++colour)
      columns.push_back(point.along(direction_of(point, first_->colours, {colour}), 1));
    for (std::size_t term = 0; term < first_->input_of.size(); ++term) {
      auto const &own = first_->input_of[term];
      for (std::uint32_t colour = 0; colour < own.size(); ++colour)
        if (own[colour] != Colouring::none && columns[colour][term]) *columns[colour][term] /= point.scale(own[colour]);
    }
  }
  if (second_) second = hessians(inputs, parameters, seeds, tolerance);
  SharpVector result;
  for (std::size_t k = 0; k < requests_.size(); ++k) {
    DerivativeRequest const &request = requests_[k];
    switch (request.kind) {
    case DerivativeKind::jacobian:
    case DerivativeKind::gradient:
    case DerivativeKind::vjp: add_first(request, columns, seeds[k], result); break;
    case DerivativeKind::hessian: result.insert(result.end(), second[k].begin(), second[k].end()); break;
    case DerivativeKind::jvp: {
      PointDifferences const point = point_of(*given_, inputs, parameters, tolerance);
      Vector direction(inputs.size(), 0);
      for (std::size_t j = 0; j < seeds[k].size(); ++j) direction[request.input_slots[j]] = seeds[k][j];
      SharpVector const all = point.along(direction, 1);
      for (std::uint32_t const output : request.output_slots) {
        SharpSum sum;
        for (auto const &[term, factor] : given_->addends.of(output)) sum.add(all[term], factor);
        result.push_back(sum.result());
      }
      break;
    }
    }
  }
  return result;
}

} // namespace symreal
