// Iterations that are those of two loops, one in the other: as in the product of two matrices, or over the half of one.
//
// A step counts its iterations through. Where an index neither grows nor falls with that count, it often does so with
// the turns of two loops; then no table is needed, and what stays the same in the inner loop is read before it.
#pragma once

#include "engine/plan/reroll/loop_program.h"

#include <algorithm>
#include <functional>

namespace symreal::reroll {

// How many iterations lie before a turn of the outer loop, and in it; of `turns`, how many there are.
std::int64_t begin_of(Nest const &nest, std::int64_t turn);
std::int64_t length_of(Nest const &nest, std::int64_t turn);

// The turns of the two loops that an iteration belongs to.
struct Turn {
  std::uint32_t outer, inner;
};
Turn turn_of(Nest const &nest, std::uint32_t iteration);

// Of a value for each iteration one for each turn of the outer loop, if the inner one does not change it.
template <typename Value, typename Same = std::equal_to<>>
std::optional<std::vector<Value>> by_turns(std::vector<Value> const &values, Nest const &nest, Same same = {}) {
  std::vector<Value> result;
  for (std::int64_t turn = 0; turn < nest.turns; ++turn) {
    auto const begin = values.begin() + begin_of(nest, turn), end = values.begin() + begin_of(nest, turn + 1);
    if (!std::all_of(begin, end, [&](Value const &value) { return same(value, *begin); })) return {};
    result.push_back(*begin);
  }
  return result;
}

// Of a leaf that stands for values, that of an iteration. `nest`: that of its step.
double value_at(Leaf const &leaf, std::uint32_t iteration, std::optional<Nest> const &nest);

// Of an element for each turn of the outer loop, the access for each iteration.
Access in_turns(Access const &of_turns, Nest const &nest);

// first + outer * i + inner * j in turn i of the outer loop and turn j of the inner one.
struct NestedAccess {
  std::int64_t first, outer, inner;
};

// None where the elements do not fit.
std::optional<NestedAccess> nested(Access const &access, Nest const &nest);

// The nest that fits most of those accesses that are listed. None where it fits none of them.
std::optional<Nest> nest_of(std::uint32_t count, std::vector<Access const *> const &accesses);
// The one that is known before, or likewise.
std::optional<Nest> nest_of(Step const &step);

} // namespace symreal::reroll
