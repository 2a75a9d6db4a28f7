// Numbers of single precision: how they are printed, rounded and compared.
#include "engine/emit/languages/languages.h"
#include "engine/graph/evaluate.h"
#include "engine/graph/graph_text.h"
#include "runtime/replay/compare.h"

#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

Language single(std::string_view name) { return in_single_precision(*find_language(name)); }

TEST(SinglePrecision, ConstantsAreTheShortestThatReadBackToTheNearestFloat) {
  Language const c = single("c");
  EXPECT_EQ(constant(c, 0.1), "0.1f");
  EXPECT_EQ(constant(c, 1.0 / 3), "0.33333334f");
  EXPECT_EQ(constant(c, 1e-5), "1e-05f");
  EXPECT_EQ(constant(c, -0.0), "-0.0f");
  EXPECT_EQ(constant(c, 16777217), "16777216.0f");
  EXPECT_EQ(constant(c, 1e-60), "0.0f");
  EXPECT_EQ(constant(c, HUGE_VAL), "INFINITY");
  EXPECT_EQ(constant(single("fortran"), 1e-5), "1e-05");
  EXPECT_EQ(constant(single("rust"), 2), "2.0");
  EXPECT_EQ(constant(single("java"), 1e30), "1e+30f");
}

TEST(SinglePrecision, WordsOfALanguageStandInItsPatterns) {
  EXPECT_EQ(with_words(*find_language("c"), "$real x = 0.0$suffix; $other"), "double x = 0.0; $other");
  EXPECT_EQ(with_words(single("c"), "$real x = 0.0$suffix; $other"), "float x = 0.0f; $other");
  EXPECT_EQ(with_words(single("fortran"), "$kind $f"), "c_float f");
  EXPECT_EQ(fill(single("java"), "$Real.isFinite($x)", {{"x", "t0"}}), "Float.isFinite(t0)");
}

TEST(SinglePrecision, NumbersAreRoundedToTheNearestOrToASide) {
  float const above = std::nextafter(1.0F, 2.0F);
  EXPECT_EQ(rounded(1 + 1e-10, Rounding::none), 1 + 1e-10);
  EXPECT_EQ(rounded(1 + 1e-10, Rounding::to_single), 1);
  EXPECT_EQ(rounded(1 + 1e-10, Rounding::up_to_single), above);
  EXPECT_EQ(rounded(above - 1e-10, Rounding::down_to_single), 1);
  EXPECT_EQ(rounded(0.5, Rounding::up_to_single), 0.5);
  EXPECT_EQ(rounded(1e39, Rounding::to_single), HUGE_VAL);
}

TEST(SinglePrecision, AGraphRoundsEachNumberThatItComputes) {
  Graph const graph = read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\"\noutput \"y\"\n%0 = input 0\n"
                                 "%1 = mul %0 0.1\n%2 = sub %1 0.1\nresult 0 %2\n",
                                 "test");
  double const x = 1 + 1e-10;
  EXPECT_NE(evaluate_sample(graph, {&x, 1}, {}).outputs[0], 0);
  EXPECT_EQ(evaluate_sample(graph, {&x, 1}, {}, {}, Rounding::to_single).outputs[0], 0);
  double const huge = 1e300;
  EXPECT_TRUE(evaluate_sample(graph, {&huge, 1}, {}).premises.finite);
  EXPECT_FALSE(evaluate_sample(graph, {&huge, 1}, {}, {}, Rounding::to_single).premises.finite);
}

TEST(SinglePrecision, DistancesAreThoseOfFloats) {
  EXPECT_EQ(ulp_distance(1.0F, std::nextafter(1.0F, 2.0F)), 1u);
  EXPECT_EQ(ulp_distance(0.0F, -0.0F), 0u);
  EXPECT_EQ(ulp_distance(-1.4e-45F, 1.4e-45F), 2u);
  OutputComparison comparison;
  comparison.add_single(0, 1, std::nextafter(1.0F, 2.0F), 1e-3);
  EXPECT_EQ(comparison.worst_ulp, 1u);
  EXPECT_EQ(comparison.different, 0u);
  comparison.add_single(1, 1, 1.01, 1e-3);
  EXPECT_EQ(comparison.different, 1u);
}

} // namespace
} // namespace symreal
