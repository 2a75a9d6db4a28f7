#include "engine/plan/nest.h"

#include <ranges>
#include <set>

namespace symreal::reroll {

std::int64_t begin_of(Nest const &nest, std::int64_t turn) {
  return turn * nest.inner + nest.growth * (turn * (turn - 1) / 2);
}

std::int64_t length_of(Nest const &nest, std::int64_t turn) { return nest.inner + nest.growth * turn; }

Turn turn_of(Nest const &nest, std::uint32_t iteration) {
  auto const turns = std::views::iota(std::uint32_t{1}, nest.turns);
  auto const outer = static_cast<std::uint32_t>(
      std::ranges::partition_point(turns, [&](std::uint32_t turn) { return begin_of(nest, turn) <= iteration; }) -
      turns.begin());
  return {outer, static_cast<std::uint32_t>(iteration - begin_of(nest, outer))};
}

Access access_of(std::vector<std::uint32_t> elements) {
  std::int64_t const first = elements.front(),
                     step = elements.size() == 1 ? 0 : static_cast<std::int64_t>(elements[1]) - first;
  for (std::size_t k = 0; k < elements.size(); ++k)
    if (elements[k] != first + step * static_cast<std::int64_t>(k)) return {0, 0, std::move(elements)};
  return {first, step};
}

Access in_turns(Access const &of_turns, Nest const &nest) {
  if (!of_turns.is_listed() && of_turns.step == 0) return of_turns;
  Access access;
  for (std::uint32_t turn = 0; turn < nest.turns; ++turn)
    access.elements.resize(static_cast<std::size_t>(begin_of(nest, turn + std::int64_t{1})),
                           static_cast<std::uint32_t>(of_turns.at(turn)));
  return access;
}

namespace {

// Nest with this first inner count and growth and exactly `count` iterations; nullopt if it does not fit.
std::optional<Nest> with_turns(std::uint32_t inner, std::int32_t growth, std::uint32_t count) {
  Nest nest{1, inner, growth};
  while (begin_of(nest, nest.turns) < count && length_of(nest, nest.turns) > 0) ++nest.turns;
  if (nest.turns < 2 || begin_of(nest, nest.turns) != count) return {};
  return nest;
}

// Length of the run of elements from `begin` on that advance by a constant step.
std::uint32_t run_from(std::size_t begin, std::vector<std::uint32_t> const &elements) {
  std::size_t end = std::min(begin + 2, elements.size());
  auto const step = [&](std::size_t k) {
    return static_cast<std::int64_t>(elements[k]) - static_cast<std::int64_t>(elements[k - 1]);
  };
  while (end < elements.size() && step(end) == step(begin + 1)) ++end;
  return static_cast<std::uint32_t>(end - begin);
}

} // namespace

std::optional<NestedAccess> nested(Access const &access, Nest const &nest) {
  auto const at = [&](std::int64_t k) { return static_cast<std::int64_t>(access.at(static_cast<std::size_t>(k))); };
  std::int64_t const second = begin_of(nest, 1);
  std::int64_t const long_turn = nest.inner > 1 ? 0 : second; // a turn with at least two inner iterations
  NestedAccess const result{at(0), at(second) - at(0), at(long_turn + 1) - at(long_turn)};
  for (std::int64_t turn = 0; turn < nest.turns; ++turn)
    for (std::int64_t k = 0; k < length_of(nest, turn); ++k)
      if (at(begin_of(nest, turn) + k) != result.first + result.outer * turn + result.inner * k) return {};
  return result;
}

std::optional<Nest> nest_of(std::uint32_t count, std::vector<Access const *> const &accesses) {
  std::set<Nest> candidates;
  for (Access const *access : accesses) {
    if (!access->is_listed()) continue;
    std::uint32_t const first = run_from(0, access->elements), second = run_from(first, access->elements);
    std::int32_t const grown = static_cast<std::int32_t>(second) - static_cast<std::int32_t>(first);
    for (std::uint32_t const inner : {first, std::uint32_t{1}})
      for (std::int32_t const growth : {0, 1, -1, grown})
        if (inner > 1 || growth > 0)
          if (std::optional<Nest> const nest = with_turns(inner, growth, count)) candidates.insert(*nest);
  }
  std::optional<Nest> best;
  std::ptrdiff_t most = 0;
  for (Nest const &nest : candidates) {
    std::ptrdiff_t const fitting = std::ranges::count_if(
        accesses, [&](Access const *access) { return access->is_listed() && nested(*access, nest); });
    if (fitting > most) best = nest, most = fitting;
  }
  return best;
}

} // namespace symreal::reroll
