#include "engine/plan/loop_function.h"

#include <gtest/gtest.h>

namespace symreal::reroll {
namespace {

LoopStep storing(std::vector<Access> const &accesses) {
  LoopStep step{{}, 20};
  for (Access const &access : accesses) step.stores.push_back({0, false, access});
  return step;
}

TEST(SideBySide, StoresOfOneIterationMustNotBeNeighbours) {
  EXPECT_TRUE(is_side_by_side(storing({{0, 1}, {20, 1}, {40, -1}})));
  EXPECT_TRUE(is_side_by_side(storing({{0, 2}})));
  EXPECT_TRUE(is_side_by_side(storing({{0, 2}, {40, 2}})));
  EXPECT_FALSE(is_side_by_side(storing({{0, 2}, {1, 2}})));
  EXPECT_FALSE(is_side_by_side(storing({{41, -8}, {47, -8}})));
  LoopStep step = storing({{0, 2}});
  step.stores.push_back({0, true, {1, 2}}); // of another array
  EXPECT_TRUE(is_side_by_side(step));
}

TEST(SideBySide, NoIterationMayWaitForAnotherOne) {
  LoopStep step = storing({{0, 1}});
  step.leaves.push_back({Array::memory, {5, 1}});
  EXPECT_TRUE(is_side_by_side(step));
  step.leaves.push_back({.array = Array::memory, .access = {3}, .is_carried = true});
  EXPECT_FALSE(is_side_by_side(step));
  EXPECT_FALSE(is_side_by_side(storing({{7, 0}})));
}

TEST(SideBySide, WhereATableSaysWhatIsStoredNothingIsKnown) {
  Access listed;
  for (std::uint32_t k = 0; k < 20; ++k) listed.elements.push_back(k * k);
  EXPECT_FALSE(is_side_by_side(storing({listed})));
}

// gcc unrolls a loop in a loop that goes round a few times, and then its iterations are neighbours.
TEST(SideBySide, ShortLoopsInLoopsAreUnrolled) {
  auto const in_rows = [](Nest const &nest) {
    Access access;
    for (std::uint32_t i = 0; i < nest.turns; ++i)
      for (std::int64_t j = 0; j < nest.inner + nest.growth * std::int64_t{i}; ++j)
        access.elements.push_back(static_cast<std::uint32_t>(100 * i + j));
    LoopStep step = storing({access});
    step.count = static_cast<std::uint32_t>(access.elements.size());
    return step;
  };
  EXPECT_FALSE(is_side_by_side(in_rows({5, 4, 0})));
  EXPECT_FALSE(is_side_by_side(in_rows({5, 16, 0})));
  EXPECT_TRUE(is_side_by_side(in_rows({5, 17, 0})));
  EXPECT_TRUE(is_side_by_side(in_rows({5, 4, 1})));
}

TEST(SideBySide, WhatIsComputedOnceIsNoLoop) {
  LoopStep step = storing({{0}});
  step.count = 1;
  EXPECT_FALSE(is_side_by_side(step));
}

} // namespace
} // namespace symreal::reroll
