// Graphs in extended precision, and what counts as near to the exact value.
#include "engine/graph/evaluate.h"
#include "engine/graph/extended.h"
#include "engine/graph/graph_text.h"
#include "runtime/replay/compare.h"

#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

Graph read(std::string const &body) {
  return read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\"\noutput \"y\"\n%0 = input 0\n" + body, "test");
}

std::optional<std::vector<long double>> outputs(Graph const &graph, double x) {
  std::vector<double> const inputs = {x};
  return evaluate_extended(graph, inputs, {}, evaluate(graph, inputs, {}));
}

TEST(Extended, KeepsWhatDoublesRoundAway) {
  Graph const graph = read("%1 = add %0 1e17\n%2 = sub %1 1e17\n%3 = div %2 3\nresult 0 %3\n");
  ASSERT_EQ(obstacle_to_extended(graph), "");
  EXPECT_EQ(evaluate_sample(graph, std::vector<double>{1}, {}).outputs[0], 0);
  EXPECT_EQ(outputs(graph, 1)->at(0), 1.0L / 3);
}

TEST(Extended, FunctionsToo) {
  Graph const graph = read("%1 = sin %0\n%2 = cos %0\n%3 = mul %1 %1\n%4 = mul %2 %2\n%5 = add %3 %4\n%6 = sub %5 1\n"
                           "result 0 %6\n");
  EXPECT_LT(std::fabs(outputs(graph, 1.6)->at(0)), 0x1p-60L);
}

TEST(Extended, ADecisionThatFallsOtherwiseTellsNothing) {
  // x + 1e17 > 1e17
  Graph const graph = read("%1 = add %0 1e17\n%2 = gt %1 1e17\n%3 = select %2 %0 5\nresult 0 %3\n");
  EXPECT_FALSE(outputs(graph, 1));
  EXPECT_EQ(outputs(graph, 100)->at(0), 100);
  EXPECT_EQ(outputs(graph, -100)->at(0), 5);
}

TEST(Extended, JumpsAreDecisions) {
  Graph const floor = read("%1 = add %0 1e17\n%2 = sub %1 1e17\n%3 = floor %2\nresult 0 %3\n");
  EXPECT_FALSE(outputs(floor, 1));
  EXPECT_EQ(outputs(floor, 32)->at(0), 32);
  Graph const fmod = read("%1 = fmod %0 1\nresult 0 %1\n");
  EXPECT_EQ(outputs(fmod, 2.75)->at(0), 0.75L);
}

TEST(Extended, WhatIsNotActiveDecidesNothing) {
  Graph const graph = read("%1 = add %0 1e17\n%2 = sub %1 1e17\n%3 = floor %2\n%4 = lt %0 0\n%5 = select %4 %3 %0\n"
                           "result 0 %5\n");
  EXPECT_EQ(outputs(graph, 1)->at(0), 1);
}

TEST(Extended, OperationsOnTheBitsOfNumbersAreObstacles) {
  EXPECT_NE(obstacle_to_extended(read("%1 = f32 %0\nresult 0 %1\n")), "");
  EXPECT_NE(obstacle_to_extended(read("%1 = nextafter %0 1\nresult 0 %1\n")), "");
  EXPECT_NE(obstacle_to_extended(read("%1 = wide_int %0\n%2 = wide_value %1\nresult 0 %2\n")), "");
  EXPECT_EQ(obstacle_to_extended(read("%1 = f32 %0\nresult 0 %0\n")), "") << "nobody needs it";
}

TEST(Extended, NearnessIsRelativeToTheOriginals) {
  EXPECT_TRUE(is_as_near(4e-3, 1e-3, 0));
  EXPECT_FALSE(is_as_near(5e-3, 1e-3, 0));
  EXPECT_TRUE(is_as_near(5e-3, 1e-3, 1e-3));
  EXPECT_DOUBLE_EQ(error_of(1e6 + 1, 1e6), 1e-6) << "relative to the magnitude";
  EXPECT_DOUBLE_EQ(error_of(1e-6, 2e-6L), 1e-6) << "or to 1";
}

} // namespace
} // namespace symreal
