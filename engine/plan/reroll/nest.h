// Loop nests: iterations as those of two nested loops, as in a matrix product or over a triangle.
//
// A step numbers its iterations consecutively. An index that is not affine in that number is often affine in the
// indices of two nested loops; then it needs no table, and values invariant in the inner loop are read before it.
#pragma once

#include "engine/plan/reroll/loop_program.h"

#include <algorithm>
#include <functional>

namespace symreal::reroll {

// Number of iterations before a turn of the outer loop, and in it.
std::int64_t begin_of(Nest const &nest, std::int64_t turn);
std::int64_t length_of(Nest const &nest, std::int64_t turn);

// Outer and inner index of an iteration.
struct Turn {
  std::uint32_t outer, inner;
};
Turn turn_of(Nest const &nest, std::uint32_t iteration);

// One value per turn of the outer loop; nullopt if a value varies in the inner loop.
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

// Value of a leaf of kind `values` in an iteration. `nest`: that of its step.
double value_at(Leaf const &leaf, std::uint32_t iteration, std::optional<Nest> const &nest);

// Access per iteration, from an access per turn of the outer loop.
Access in_turns(Access const &of_turns, Nest const &nest);

// Affine index: first + outer * i + inner * j in turn i of the outer loop and turn j of the inner one.
struct NestedAccess {
  std::int64_t first, outer, inner;
};

// Affine index of the access; nullopt if its elements need an index table.
std::optional<NestedAccess> nested(Access const &access, Nest const &nest);

// Loop nest in which most of the listed accesses are affine; nullopt if none of them is.
std::optional<Nest> nest_of(std::uint32_t count, std::vector<Access const *> const &accesses);
// Loop nest of the step; if it is not known beforehand, the one that fits its accesses.
std::optional<Nest> nest_of(Step const &step);

} // namespace symreal::reroll
