#include "engine/plan/loop_function.h"

#include <gtest/gtest.h>

namespace symreal::reroll {
namespace {

// first + outer * i + inner * j, in that order.
Access listed(Nest const &nest, NestedAccess const &access) {
  Access result;
  for (std::int64_t i = 0; i < nest.turns; ++i)
    for (std::int64_t j = 0; j < nest.inner + nest.growth * i; ++j)
      result.elements.push_back(static_cast<std::uint32_t>(access.first + access.outer * i + access.inner * j));
  return result;
}

TEST(Nest, RowsColumnsAndTrianglesAreFound) {
  for (Nest const nest : {Nest{5, 4, 0}, Nest{2, 30, 0}, Nest{7, 1, 1}, Nest{7, 3, 1}, Nest{6, 6, -1}, Nest{4, 9, -1},
                          Nest{5, 4, 3}, Nest{4, 9, -2}})
    for (NestedAccess const place :
         {NestedAccess{3, 40, 1}, NestedAccess{2000, -40, -2}, NestedAccess{5, 0, 3}, NestedAccess{9, 7, 0}}) {
      Access const access = listed(nest, place);
      auto const count = static_cast<std::uint32_t>(access.elements.size());
      std::optional<Nest> const found = nest_of(count, {&access});
      ASSERT_TRUE(found) << nest.turns << ' ' << nest.inner << ' ' << nest.growth;
      EXPECT_EQ(*found, nest);
      std::optional<NestedAccess> const fits = nested(access, *found);
      ASSERT_TRUE(fits);
      EXPECT_EQ(fits->first, place.first);
      EXPECT_EQ(fits->outer, place.outer);
      EXPECT_EQ(fits->inner, place.inner);
    }
}

TEST(Nest, AnIterationIsOfATurnOfEachLoop) {
  for (Nest const nest : {Nest{5, 4, 0}, Nest{7, 1, 1}, Nest{4, 9, -2}, Nest{5, 4, 3}}) {
    std::uint32_t k = 0;
    for (std::uint32_t i = 0; i < nest.turns; ++i) {
      EXPECT_EQ(begin_of(nest, i), k);
      for (std::uint32_t j = 0; j < length_of(nest, i); ++j, ++k) {
        EXPECT_EQ(turn_of(nest, k).outer, i);
        EXPECT_EQ(turn_of(nest, k).inner, j);
      }
    }
  }
}

TEST(Nest, AValueMayStayTheSameInATurn) {
  Nest const nest{3, 2, 1};
  Leaf leaf{Array::values, {}, {5, 6}, true};
  std::vector<double> values;
  for (std::uint32_t k = 0; k < 9; ++k) values.push_back(value_at(leaf, k, nest));
  EXPECT_EQ(values, (std::vector<double>{5, 5, 6, 6, 6, 5, 5, 5, 5}));
  EXPECT_EQ(in_turns({7, -2}, nest).elements, (std::vector<std::uint32_t>{7, 7, 5, 5, 5, 3, 3, 3, 3}));
  EXPECT_FALSE(in_turns({7}, nest).is_listed());
}

TEST(Nest, WhatFitsNoneStaysAList) {
  Access access = listed({5, 4, 0}, {3, 40, 1});
  ++access.elements[13];
  EXPECT_FALSE(nest_of(20, {&access}));
  EXPECT_FALSE(nested(access, {5, 4, 0}));
}

TEST(Nest, WhatGrowsWithAllIterationsNeedsNone) {
  Access const steady{7, 3};
  EXPECT_FALSE(nest_of(20, {&steady}));
  EXPECT_TRUE(nested(steady, {5, 4, 0}));   // rows that follow each other
  EXPECT_FALSE(nested(steady, {5, 6, -1})); // its step differs from row to row
}

TEST(Nest, TheOneThatFitsMostIsTaken) {
  Nest const fives{4, 5, 0}, fours{5, 4, 0};
  Access const a = listed(fours, {0, 10, 2}), b = listed(fives, {0, 10, 1}), c = listed(fives, {9, 0, 1});
  EXPECT_EQ(nest_of(20, {&a, &b, &c}), fives);
  EXPECT_EQ(nest_of(20, {&a, &b}), fives); // of as many the smaller one: fewer turns of the outer loop
}

} // namespace
} // namespace symreal::reroll
