// Loop nests: iterations as those of two nested loops, as in a matrix product or over a triangle; and accesses in them.
//
// A step numbers its iterations consecutively. An index that is not affine in that number is often affine in the
// indices of two nested loops; then it needs no table, and values invariant in the inner loop are read before it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace symreal::reroll {

// A loop nest: in turn i of the outer loop, the inner loop has inner + growth * i iterations.
struct Nest {
  std::uint32_t turns, inner;
  std::int32_t growth;
  auto operator<=>(Nest const &) const = default;
};

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

// Element index of an array as a function of the iteration.
struct Access {
  std::int64_t first = 0, step = 0;         // first + step * iteration
  std::vector<std::uint32_t> elements = {}; // one per iteration if the index is not affine

  bool operator==(Access const &) const = default;
  bool is_listed() const { return !elements.empty(); }
  std::size_t at(std::size_t iteration) const {
    return is_listed() ? elements[iteration]
                       : static_cast<std::size_t>(first + step * static_cast<std::int64_t>(iteration));
  }
};

// Affine access if the elements fit, else a list.
Access access_of(std::vector<std::uint32_t> elements);

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

} // namespace symreal::reroll
