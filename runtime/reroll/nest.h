// Iterations that are those of two loops, one in the other: as in the product of two matrices, or over the half of one.
//
// A step counts its iterations through. Where an index neither grows nor falls with that count, it often does so with
// the turns of two loops; then no table is needed, and what stays the same in the inner loop is read before it.
#pragma once

#include "reroll/loop_program.h"

#include <optional>

namespace symreal::reroll {

// In turn i of the outer loop the inner one goes round inner + growth * i times.
struct Nest {
  std::uint32_t turns, inner;
  std::int32_t growth;
  auto operator<=>(Nest const &) const = default;
};

// first + outer * i + inner * j in turn i of the outer loop and turn j of the inner one.
struct NestedAccess {
  std::int64_t first, outer, inner;
};

// None where the elements do not fit.
std::optional<NestedAccess> nested(Access const &access, Nest const &nest);

// The nest that fits most of those accesses that are listed. None where it fits none of them.
std::optional<Nest> nest_of(std::uint32_t count, std::vector<Access const *> const &accesses);
std::optional<Nest> nest_of(Step const &step);

} // namespace symreal::reroll
