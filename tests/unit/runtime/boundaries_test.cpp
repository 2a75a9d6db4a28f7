// Decisions of a graph, and the samples that stand at their boundaries.
#include "engine/graph/evaluate.h"
#include "engine/graph/graph_text.h"
#include "runtime/replay/boundaries.h"

#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

Graph graph_of(std::string const &nodes) {
  return read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\" [2] = 1 2\noutput \"y\"\n" + nodes, "test");
}

std::vector<Op> conditions(Graph const &graph) {
  std::vector<Op> ops;
  for (Decision const &decision : decisions_of(graph)) ops.push_back(graph.nodes[decision.condition].op);
  return ops;
}

TEST(Decisions, AreTheComparisonsBelowAndOrNot) {
  Graph const graph = graph_of("%0 = input 0\n%1 = input 1\n%2 = lt %0 3\n%3 = gt %1 0\n%4 = logical_and %2 %3\n"
                               "%5 = logical_not %4\n%6 = select %5 %0 %1\n%7 = le %0 %1\n%8 = lt 1 2\n"
                               "%9 = select %8 %6 0\nresult 0 %9\nguard 0 %7 \"x <= y\"\n");
  EXPECT_EQ(conditions(graph), (std::vector{Op::lt, Op::gt, Op::le}));
  EXPECT_TRUE(decisions_of(graph)[2].is_guards);
}

TEST(Decisions, OfWhatNoResultNeedsAreNone) {
  EXPECT_TRUE(conditions(graph_of("%0 = input 0\n%1 = lt %0 3\n%2 = select %1 %0 1\nresult 0 %0\n")).empty());
}

// Both sides, with nothing between them.
void expect_neighbours(Graph const &graph, Boundaries const &found) {
  NodeId const condition = decisions_of(graph)[0].condition;
  ASSERT_GE(found.samples.size(), 2u);
  for (std::size_t k = 0; k + 1 < found.samples.size(); k += 2) {
    Sample const &yes = found.samples[k], &no = found.samples[k + 1];
    EXPECT_NE(evaluate(graph, yes.inputs, yes.parameters)[condition], 0);
    EXPECT_EQ(evaluate(graph, no.inputs, no.parameters)[condition], 0);
    for (std::size_t i = 0; i < yes.inputs.size(); ++i)
      EXPECT_LE(std::abs(yes.inputs[i] - no.inputs[i]), 4e-16 * std::abs(yes.inputs[i]));
  }
}

TEST(Boundaries, AreFoundToTheNeighbour) {
  Graph const graph = graph_of("%0 = input 0\n%1 = input 1\n%2 = mul %0 %1\n%3 = gt %2 2.5\n%4 = select %3 %0 %1\n"
                               "result 0 %4\n");
  Boundaries const found = find_boundaries(graph, 1);
  EXPECT_EQ(found.decisions, 1u);
  EXPECT_EQ(found.crossed, 1u);
  expect_neighbours(graph, found);
}

TEST(Boundaries, AreSoughtWhereNoDrawnSampleComes) {
  Graph const graph = graph_of("%0 = input 0\n%1 = input 1\n%2 = mul %0 0.001\n%3 = gt %2 1e20\n%4 = select %3 %0 %1\n"
                               "result 0 %4\n");
  Boundaries const found = find_boundaries(graph, 1);
  EXPECT_EQ(found.crossed, 1u);
  expect_neighbours(graph, found);
}

TEST(Boundaries, StayWithinTheRange) {
  Graph graph = graph_of("%0 = input 0\n%1 = input 1\n%2 = gt %0 5\n%3 = select %2 %0 %1\nresult 0 %3\n");
  graph.inputs[0].range = Range{0, 4};
  Boundaries const found = find_boundaries(graph, 1);
  EXPECT_EQ(found.decisions, 1u);
  EXPECT_EQ(found.crossed, 0u);
  EXPECT_TRUE(found.samples.empty());
}

TEST(Boundaries, MayKeepAShareOfTheDistance) {
  Graph const graph = graph_of("%0 = input 0\n%1 = input 1\n%2 = gt %0 1.25\n%3 = select %2 %0 %1\nresult 0 %3\n");
  Boundaries const found = find_boundaries(graph, 1, 0x1p-20);
  ASSERT_EQ(found.crossed, 1u);
  EXPECT_GT(found.samples[0].inputs[0] - found.samples[1].inputs[0], 1e-9);
}

TEST(Boundaries, AreTheSameForTheSameSeed) {
  Graph const graph = graph_of("%0 = input 0\n%1 = input 1\n%2 = gt %0 %1\n%3 = select %2 %0 %1\nresult 0 %3\n");
  EXPECT_EQ(find_boundaries(graph, 3).samples, find_boundaries(graph, 3).samples);
}

} // namespace
} // namespace symreal
