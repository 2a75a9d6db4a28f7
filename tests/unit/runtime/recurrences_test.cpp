// What iterations wait for, and that they wait for less.
#include "engine/graph/evaluate.h"
#include "engine/plan/reroll/bodies.h"
#include "engine/plan/reroll/recurrences.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"
#include "graph_builder.h"
#include "loop_run.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

using Builder = test::GraphBuilder;
using reroll::LoopFunction;
using reroll::LoopStep;

// The graph as loops and with short recurrences, which give the same values.
struct Loops {
  LoopFunction plain, shortened;

  explicit Loops(Graph const &graph) {
    Plan const plan = schedule(graph);
    std::optional<LoopFunction> const found = test::loops_of_compute(rerolled(plan, FloatingPoint::fast));
    EXPECT_TRUE(found);
    plain = shortened = found.value_or(LoopFunction());
    for (LoopStep &step : shortened.steps) step = with_short_recurrences(step);
    std::vector<double> inputs;
    for (std::size_t k = 0; k < graph.input_count(); ++k) inputs.push_back(std::sin(1.0 + static_cast<double>(k * k)));
    std::size_t const count = graph.results.size();
    std::vector<double> const a = test::run(plain, {}, inputs, count), b = test::run(shortened, {}, inputs, count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_NEAR(a[k], b[k], 1e-13 * std::max(1.0, std::abs(a[k])));
  }

  static LoopStep const &loop(LoopFunction const &function) {
    return *std::ranges::max_element(function.steps, {}, &LoopStep::count);
  }
};

// y = x - 0.5 y1 + 0.25 y2: both of the iterations before wait for a product, a difference and a sum.
NodeId section(Builder &make, NodeId x, NodeId y1, NodeId y2) {
  NodeId const a = make(Op::mul, y1, make.number(0.5)), b = make(Op::mul, y2, make.number(0.25));
  return make(Op::add, make(Op::sub, x, a), b);
}

TEST(Recurrences, WhatTheIterationBeforeComputesIsTakenLast) {
  Builder make;
  std::vector<NodeId> y = {make.input(0), make.input(1)};
  for (std::uint32_t k = 2; k < 60; ++k) y.push_back(section(make, make.input(k), y[k - 1], y[k - 2]));
  Loops const loops(make.finish(y));
  auto const before = reroll::recurrences(loops.loop(loops.plain)),
             after = reroll::recurrences(loops.loop(loops.shortened));
  ASSERT_EQ(before.size(), 1);
  ASSERT_EQ(after.size(), 1);
  EXPECT_EQ(before[0].leaves.size(), 2);
  EXPECT_NEAR(before[0].period, 3, 0.1);
  EXPECT_NEAR(after[0].period, 2, 0.1); // a product and a difference
  EXPECT_EQ(reroll::operations_of(loops.loop(loops.plain)), reroll::operations_of(loops.loop(loops.shortened)));
}

// The second section waits for itself alone: the first one runs ahead.
TEST(Recurrences, WhatOnlyFlowsInIsNotWaitedFor) {
  Builder make;
  std::vector<NodeId> y = {make.input(0), make.input(1)}, z = {make.input(2), make.input(3)};
  for (std::uint32_t k = 2; k < 60; ++k) {
    y.push_back(section(make, make.input(k + 2), y[k - 1], y[k - 2]));
    z.push_back(section(make, make(Op::mul, y[k], make.number(0.3)), z[k - 1], z[k - 2]));
  }
  Loops const loops(make.finish(z));
  auto const after = reroll::recurrences(loops.loop(loops.shortened));
  ASSERT_EQ(after.size(), 2);
  EXPECT_NEAR(after[0].period, 2, 0.1);
  EXPECT_NEAR(after[1].period, 2, 0.1);
}

// Beside thirty other operations nobody waits.
TEST(Recurrences, ALoopWithMuchToDoStaysAsItIs) {
  Builder make;
  std::vector<NodeId> y = {make.input(0), make.input(1)};
  for (std::uint32_t k = 2; k < 60; ++k) {
    NodeId x = make.input(k);
    for (int p = 0; p < 15; ++p) x = make(Op::add, make(Op::mul, x, make.number(0.1 + 0.05 * p)), make.input(60));
    y.push_back(section(make, x, y[k - 1], y[k - 2]));
  }
  Loops const loops(make.finish(y));
  EXPECT_EQ(loops.loop(loops.plain).body.nodes, loops.loop(loops.shortened).body.nodes);
}

// A value that the next iteration does not need for its own is carried on, and no recurrence.
TEST(Recurrences, WhatIsOnlyPassedOnIsNone) {
  Builder make;
  std::vector<NodeId> y, x = {make(Op::mul, make.input(0), make.number(0.5))};
  for (std::uint32_t k = 1; k < 60; ++k) {
    x.push_back(make(Op::mul, make(Op::add, make.input(k), make.number(1)), make.number(0.5)));
    y.push_back(make(Op::add, make(Op::mul, x[k], make.number(0.25)), x[k - 1]));
  }
  Loops const loops(make.finish(y));
  EXPECT_TRUE(reroll::recurrences(loops.loop(loops.plain)).empty());
}

} // namespace
} // namespace symreal
