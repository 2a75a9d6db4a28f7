#include "reroll/nest.h"

#include <algorithm>
#include <set>

namespace symreal::reroll {

namespace {

// Where the turn of the outer loop begins.
std::int64_t begin_of(Nest const &nest, std::int64_t turn) {
  return turn * nest.inner + nest.growth * (turn * (turn - 1) / 2);
}

std::int64_t length_of(Nest const &nest, std::int64_t turn) { return nest.inner + nest.growth * turn; }

// The nest that begins so and has so many iterations.
std::optional<Nest> with_turns(std::uint32_t inner, std::int32_t growth, std::uint32_t count) {
  Nest nest{1, inner, growth};
  while (begin_of(nest, nest.turns) < count && length_of(nest, nest.turns) > 0) ++nest.turns;
  if (nest.turns < 2 || begin_of(nest, nest.turns) != count) return {};
  return nest;
}

// How many elements from the first on are a step apart.
std::uint32_t first_run(std::vector<std::uint32_t> const &elements) {
  std::size_t end = 2;
  auto const step = [&](std::size_t k) {
    return static_cast<std::int64_t>(elements[k]) - static_cast<std::int64_t>(elements[k - 1]);
  };
  while (end < elements.size() && step(end) == step(1)) ++end;
  return static_cast<std::uint32_t>(end);
}

} // namespace

std::optional<NestedAccess> nested(Access const &access, Nest const &nest) {
  auto const at = [&](std::int64_t k) { return static_cast<std::int64_t>(access.at(static_cast<std::size_t>(k))); };
  std::int64_t const second = begin_of(nest, 1);
  std::int64_t const long_turn = nest.inner > 1 ? 0 : second; // in which the inner loop goes round twice or more
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
    for (std::uint32_t const inner : {first_run(access->elements), std::uint32_t{1}})
      for (std::int32_t const growth : {0, 1, -1})
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

std::optional<Nest> nest_of(Step const &step) {
  std::vector<Access const *> accesses;
  for (Leaf const &leaf : step.leaves) accesses.push_back(&leaf.access);
  for (Store const &store : step.stores) accesses.push_back(&store.access);
  return nest_of(step.count, accesses);
}

} // namespace symreal::reroll
