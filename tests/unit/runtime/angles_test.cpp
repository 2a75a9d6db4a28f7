// Which sines and cosines function compute begins with.
#include "engine/plan/schedule/angles.h"
#include "graph_builder.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace symreal {
namespace {

using Builder = test::GraphBuilder;

// The sum of the sines of x y + 1, x y + 2, ...
Graph sines_of_sums(unsigned count) {
  Builder make;
  NodeId const product = make(Op::mul, make.input(0), make.input(1));
  NodeId sum = make(Op::sin, make.input(0));
  for (unsigned k = 1; k <= count; ++k) sum = make(Op::add, sum, make(Op::sin, make(Op::add, product, make.number(k))));
  return make.finish({sum, make.input(1)});
}

bool computes(PlanFunction const &body, NodeId id) {
  return std::ranges::find(body.variables, id) != body.variables.end();
}

TEST(Angles, ThatSumsMakeOfInputsComeFirst) {
  Graph const graph = sines_of_sums(6);
  Plan const plan = with_angles(schedule(graph));
  EXPECT_EQ(plan.angles.inputs, std::vector<std::uint32_t>{0});
  ASSERT_EQ(plan.angles.computed, 6);
  EXPECT_EQ(describe(plan.angles), "compute: sine and cosine of 1 input and 6 computed angles side by side");
  NodeId const product = 2;
  ASSERT_EQ(graph.nodes[product].op, Op::mul);
  EXPECT_TRUE(computes(*plan.find(FunctionKind::angles), product));
  EXPECT_FALSE(computes(plan.compute(), product));
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    if (graph.nodes[id].op != Op::sin) continue;
    ASSERT_TRUE(plan.element(id).has_value());
    EXPECT_EQ(plan.element(id)->array, Array::sine);
  }
  // An input that is a result is read before anything is stored.
  EXPECT_TRUE(computes(plan.compute(), graph.results[1]));
}

TEST(Angles, ThatAreFewStayWhereTheyWere) {
  Graph const graph = sines_of_sums(3);
  Plan const plan = with_angles(schedule(graph));
  EXPECT_TRUE((plan.angles.computed == 0));
  EXPECT_EQ(plan.angles.size(), 1);
}

// Each thread has its own statements.
TEST(Angles, ThatAreComputedStayWithTheirThreads) {
  Graph const graph = sines_of_sums(6);
  Plan plan = schedule(graph);
  plan.compute().parts = {{0, 2}, {0, plan.compute().variables.size()}};
  plan = with_angles(std::move(plan));
  EXPECT_TRUE((plan.angles.computed == 0));
  EXPECT_EQ(plan.compute().parts.back().end, plan.compute().variables.size());
}

// Every angle is a result, too, and would be computed twice.
TEST(Angles, ThatOthersReadStayWhereTheyWere) {
  Builder make;
  std::vector<NodeId> results;
  for (unsigned k = 1; k <= 6; ++k) {
    NodeId const angle = make(Op::mul, make.input(0), make.number(k));
    results.push_back(angle);
    results.push_back(make(Op::cos, angle));
  }
  Graph const graph = make.finish(results);
  EXPECT_EQ(with_angles(schedule(graph)).angles.size(), 0);
}

// The sine of a sine is known later, as is that of a quotient.
TEST(Angles, ThatOtherOperationsMakeStayWhereTheyWere) {
  Builder make;
  std::vector<NodeId> results;
  for (unsigned k = 1; k <= 6; ++k) {
    NodeId const sine = make(Op::sin, make(Op::mul, make.input(0), make.number(k)));
    results.push_back(make(Op::sin, make(Op::mul, sine, make.number(k))));
    results.push_back(make(Op::cos, make(Op::div, make.number(k), make.input(0))));
  }
  Graph const graph = make.finish(results);
  Plan const plan = with_angles(schedule(graph));
  EXPECT_EQ(plan.angles.computed, 6);
}

// What stands in an arm of a select is computed there.
TEST(Angles, ThatAreComputedStayInProgramsWithBlocks) {
  Builder make;
  NodeId sum = make.number(0);
  for (unsigned k = 1; k <= 6; ++k)
    sum = make(Op::add, sum, make(Op::sin, make(Op::mul, make.input(0), make.number(k))));
  NodeId const root = make(Op::sqrt, make.input(1)), arm = make(Op::mul, root, make(Op::exp, root));
  NodeId const choice = make(Op::select, make(Op::lt, make.input(0), make.number(1)), arm, make.number(2));
  Graph const graph = make.finish({make(Op::add, sum, choice)});
  EXPECT_EQ(with_angles(schedule(graph)).angles.size(), 0);
}

} // namespace
} // namespace symreal
