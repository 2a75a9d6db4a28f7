// What is known of signs after some equations, and after some are undone.
#include "engine/plan/reroll/relative_signs.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace symreal {
namespace {

using reroll::RelativeSigns;

TEST(RelativeSigns, OfTwoValuesFollowFromThoseOfOthers) {
  RelativeSigns signs(4);
  EXPECT_TRUE(signs.relate({0, 1}, true));
  EXPECT_TRUE(signs.relate({2, 3}, false));
  EXPECT_TRUE(signs.relate({1, 2}, true));
  EXPECT_TRUE(signs.relate({0, 3}, false));
  EXPECT_FALSE(signs.relate({0, 3}, true));
}

TEST(RelativeSigns, OfAProductFollowFromItsFactors) {
  RelativeSigns signs(6);
  EXPECT_TRUE(signs.relate({0, 1, 2}, false)); // 0 is the product of 1 and 2
  EXPECT_TRUE(signs.relate({3, 1, 4}, true));
  EXPECT_TRUE(signs.relate({0, 3}, false));
  EXPECT_FALSE(signs.relate({2, 4}, false));
  EXPECT_TRUE(signs.relate({2, 4}, true));
  EXPECT_TRUE(signs.of({2, 4}).is_known());
  EXPECT_FALSE(signs.of({2, 5}).is_known());
  EXPECT_TRUE(signs.relate({2}, true));
  EXPECT_EQ(signs.of({0, 1}), (RelativeSigns::Sign{{}, true}));
}

TEST(RelativeSigns, ComeBackToAMark) {
  RelativeSigns signs(4);
  EXPECT_TRUE(signs.relate({0, 1}, true));
  std::size_t const mark = signs.mark();
  EXPECT_TRUE(signs.relate({1, 2}, true));
  EXPECT_TRUE(signs.relate({0, 1, 3}, true));
  EXPECT_TRUE(signs.of({3}).is_known());
  EXPECT_FALSE(signs.relate({0, 2}, true));
  signs.undo_to(mark);
  EXPECT_FALSE(signs.of({3}).is_known());
  EXPECT_TRUE(signs.relate({0, 2}, true));
  EXPECT_FALSE(signs.relate({0, 1}, false));
}

// A chain of products of what is free depends on more than is looked at, and takes no time.
TEST(RelativeSigns, OfLongProductsAreLeftAlone) {
  constexpr std::uint32_t length = 10000;
  RelativeSigns signs(2 * length);
  for (std::uint32_t k = 0; k + 1 < length; ++k) EXPECT_TRUE(signs.relate({k, k + 1, length + k}, false));
  signs.keep();
  for (std::uint32_t k = 1; k < length; ++k) signs.relate({0, k}, false);
  EXPECT_FALSE(signs.of({0}).is_known());
}

// Each follows from the next: what is kept is looked through once, in whatever order one asks.
TEST(RelativeSigns, OfLongChainsAreFound) {
  constexpr std::uint32_t length = 100000;
  RelativeSigns signs(length + 2);
  for (std::uint32_t k = 0; k + 2 < length; ++k)
    EXPECT_TRUE(signs.relate({k, k + 1 + k % 2, length, length + 1}, k % 3 == 0));
  signs.keep();
  EXPECT_EQ(signs.of({0}), signs.of({0}));
  EXPECT_TRUE(signs.relate({length - 1}, false));
  EXPECT_TRUE(signs.relate({length - 2}, true));
  EXPECT_TRUE(signs.relate({length}, true));
  EXPECT_TRUE(signs.relate({length + 1}, true));
  signs.keep();
  std::vector<char> const negatives = signs.negatives();
  for (std::uint32_t k = 0; k < length; ++k) {
    RelativeSigns::Sign const sign = signs.of({k});
    EXPECT_TRUE(sign.is_known());
    EXPECT_EQ(sign.negated, negatives[k] != 0);
  }
}

// Whatever the equations are and where one comes back: as assignments tried one by one say.
TEST(RelativeSigns, OfRandomProductsAgreeWithAllAssignments) {
  std::mt19937 random(5);
  auto const below = [&](unsigned count) { return std::uniform_int_distribution<unsigned>(0, count - 1)(random); };
  constexpr unsigned values = 8;
  for (unsigned sample = 0; sample < 200; ++sample) {
    RelativeSigns signs(values);
    std::vector<unsigned> left(1U << values); // assignments that no equation excludes
    std::iota(left.begin(), left.end(), 0U);
    for (unsigned step = 0; step < 14; ++step) {
      std::array const factors = {below(values), below(values), below(values)};
      bool const negative = below(2) != 0;
      std::vector<unsigned> kept;
      for (unsigned const assignment : left) {
        unsigned product = 0;
        for (unsigned const factor : factors) product ^= assignment >> factor & 1;
        if ((product != 0) == negative) kept.push_back(assignment);
      }
      if (below(2) != 0) signs.keep();
      std::size_t const mark = signs.mark();
      EXPECT_EQ(signs.relate({factors[0], factors[1], factors[2]}, negative), !kept.empty());
      if (kept.empty()) continue;
      bool const comes_back = below(3) == 0;
      if (comes_back)
        signs.undo_to(mark);
      else
        left = std::move(kept);
    }
    unsigned assignment = 0;
    std::vector<char> const negatives = signs.negatives();
    for (unsigned value = 0; value < values; ++value) assignment |= static_cast<unsigned>(negatives[value]) << value;
    EXPECT_TRUE(std::ranges::binary_search(left, assignment));
  }
}

} // namespace
} // namespace symreal
