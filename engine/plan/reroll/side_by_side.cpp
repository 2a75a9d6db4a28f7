#include "engine/plan/reroll/side_by_side.h"

#include "engine/plan/reroll/nest.h"

#include <cstdlib>

namespace symreal::reroll {

namespace {

constexpr std::int64_t most_unrolled = 16; // iterations of an inner loop: gcc's max-completely-peel-times

// Access as an affine index with the innermost loop's step; nullopt if it needs an index table.
std::optional<NestedAccess> in_loop(Access const &access, std::optional<Nest> const &nest) {
  if (!access.is_listed()) return NestedAccess{access.first, 0, access.step};
  return nest ? nested(access, *nest) : std::nullopt;
}

bool are_neighbours(NestedAccess const &a, NestedAccess const &b) {
  return a.inner == b.inner && a.outer == b.outer && std::abs(a.first - b.first) < std::abs(a.inner);
}

} // namespace

bool is_side_by_side(Step const &step) {
  if (step.count == 1) return false;
  if (std::ranges::any_of(step.leaves, [](Leaf const &leaf) { return leaf.kind == Leaf::Kind::carried; })) return false;
  std::optional<Nest> const nest = nest_of(step);
  if (nest && nest->growth == 0 && nest->inner <= most_unrolled) return false;
  std::vector<std::pair<bool, NestedAccess>> stores;
  for (Store const &store : step.stores) {
    std::optional<NestedAccess> const here = in_loop(store.access, nest);
    if (!here || here->inner == 0) return false;
    for (auto const &[is_result, other] : stores)
      if (is_result == store.is_result && are_neighbours(*here, other)) return false;
    stores.emplace_back(store.is_result, *here);
  }
  return true;
}

} // namespace symreal::reroll
