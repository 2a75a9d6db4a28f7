#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"

#include <symreal/decisions.h>
#include <symreal/external.h>

#include <gtest/gtest.h>

namespace symreal {
namespace {

int calls = 0;
double twice(double x) { return ++calls, 2 * x; }
void swap_ends(int n, double *values) { std::swap(values[0], values[n - 1]); }

constexpr ExternalDescription pure_twice = {"twice", true, "returns number takes number", "", "f.h", 1, 1};
constexpr ExternalDescription counted_twice = {"twice", false, "returns number takes number", "", "f.h", 1, 1};
constexpr ExternalDescription swapping = {"swap_ends", true, "takes integer \"int\" updated 1", "0 1*$0", "f.h", 2, 1};

class ExternalTest : public testing::Test {
protected:
  void SetUp() override {
    trace::session().pool.begin({.values = true, .places = false});
    trace::session().externals.begin();
    x = trace::session().pool.leaf(Node::input(0), 3.0);
  }
  void TearDown() override { trace::session().pool.end(); }
  RealNumber x;
};

TEST_F(ExternalTest, APureCallIsAnExpression) {
  auto const f = symreal_external(twice, pure_twice);
  RealNumber const a = f(x), b = f(x), constant = f(2.0);
  EXPECT_EQ(symreal_value(a), 6);
  EXPECT_EQ(a.to_bits(), b.to_bits());
  EXPECT_FALSE(constant.is_node());
  EXPECT_EQ(constant.plain(), 4);
}

TEST_F(ExternalTest, ACallWithEffectsIsKept) {
  auto const f = symreal_external(twice, counted_twice);
  calls = 0;
  RealNumber const a = f(x), b = f(x), constant = f(2.0);
  EXPECT_EQ(calls, 3);
  EXPECT_NE(a.to_bits(), b.to_bits());
  EXPECT_TRUE(constant.is_node());
  Graph graph;
  trace::session().externals.end(graph);
  graph.nodes = trace::session().pool.nodes().nodes();
  ASSERT_EQ(graph.externals.size(), 1u);
  unsigned chain = 0;
  for (NodeId call = graph.last_effect; graph.nodes[call].op == Op::call_in_order; call = graph.nodes[call].operand[2])
    ++chain;
  EXPECT_EQ(chain, 3u);
  EXPECT_EQ(graph.nodes[graph.last_effect].attribute, Attribute::variable);
}

TEST_F(ExternalTest, AnArrayHasTheSizeOfItsCall) {
  auto const f = symreal_external(swap_ends, swapping);
  RealNumber values[3] = {x, 1.0, 7.0};
  f(3, values);
  EXPECT_EQ(symreal_value(values[0]), 7);
  EXPECT_EQ(symreal_value(values[2]), 3);
  EXPECT_TRUE(values[0].is_node() && values[1].is_node());
  f(2, values);
  EXPECT_EQ(symreal_value(values[0]), 1);
  ASSERT_EQ(trace::session().externals.functions().size(), 2u);
  EXPECT_EQ(trace::session().externals.functions()[1].parameters[1].count, 2u);
}

TEST_F(ExternalTest, EffectsAreRefusedUnderACondition) {
  auto const call = [&] {
    PathScope const arm(x > 0.0);
    (void)symreal_external(twice, counted_twice)(x);
  };
  EXPECT_EXIT(call(), testing::ExitedWithCode(1), "'twice' may have effects.*\\[SYM066\\]");
}

TEST_F(ExternalTest, AnArrayIsThereAndHasElements) {
  EXPECT_EXIT(symreal_external(swap_ends, swapping)(3, nullptr), testing::ExitedWithCode(1),
              "null pointer.*\\[SYM067\\]");
  EXPECT_EXIT(symreal_external(swap_ends, swapping)(0, &x), testing::ExitedWithCode(1), "no elements.*\\[SYM067\\]");
}

} // namespace
} // namespace symreal
