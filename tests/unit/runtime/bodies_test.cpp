// Passes on the bodies of loops: what they save, and that the loops compute the same.
#include "engine/graph/evaluate.h"
#include "engine/optimise/passes/pass.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/angles.h"
#include "graph_builder.h"
#include "loop_run.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

using Builder = test::GraphBuilder;
using reroll::Leaf;
using reroll::LoopFunction;
using reroll::LoopStep;

Graph by_passes(Graph graph, bool) { return run_passes(std::move(graph), default_passes(), {FloatingPoint::fast, 1}); }

struct Looped {
  Plan plan;
  LoopFunction compute;

  LoopStep const &loop() const {
    return *std::ranges::max_element(compute.steps, {}, [](LoopStep const &step) { return step.count; });
  }
  std::size_t operations() const { return reroll::operations_of(loop().body); }
  std::size_t leaves(Array array) const {
    return static_cast<std::size_t>(std::ranges::count(loop().leaves, array, &Leaf::array));
  }
};

// Of this graph, which must outlive it; with the values that the graph has.
Looped looped(Graph const &graph) {
  Plan const plan = with_angles(schedule(graph));
  std::optional<LoopFunction> const before = test::loops_of_compute(rerolled(plan, FloatingPoint::fast)),
                                    after = test::loops_of_compute(
                                        improved(rerolled(plan, FloatingPoint::fast), plan.angles, by_passes));
  EXPECT_TRUE(before && after);
  if (!before || !after) return {plan, {}};
  std::vector<double> inputs;
  for (std::size_t k = 0; k < graph.input_count(); ++k) inputs.push_back(std::sin(1.0 + static_cast<double>(k * k)));
  std::vector<double> const values = evaluate(graph, inputs, {});
  std::size_t const count = graph.results.size();
  std::vector<double> const angles = test::angles_of(plan, inputs);
  std::vector<double> const plain = test::run(*before, angles, inputs, count),
                            cheap = test::run(*after, angles, inputs, count);
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_EQ(plain[k], values[graph.results[k]]);
    EXPECT_NEAR(cheap[k], values[graph.results[k]], 1e-12 * std::max(1.0, std::abs(cheap[k])));
  }
  return {plan, *after};
}

// sum + a x + b x, where a and b are other numbers in each iteration: one number, a + b.
TEST(Bodies, WhatTablesAloneSayGoesIntoATable) {
  Builder make;
  NodeId sum = make.input(0);
  for (std::uint32_t k = 1; k <= 60; ++k) {
    NodeId const x = make.input(k);
    NodeId const a = make(Op::mul, x, make.number(1 + 0.25 * k * k)), b = make(Op::mul, x, make.number(3 - 0.5 * k));
    sum = make(Op::add, make(Op::add, sum, a), b);
  }
  Graph const graph = make.finish({sum});
  Looped const result = looped(graph);
  EXPECT_EQ(result.operations(), 2);
  EXPECT_EQ(result.leaves(Array::values), 1);
}

// The same with a period of 3 in one table and of 2 in the other: 6 rows.
TEST(Bodies, TablesOfSeveralPeriodsMakeOneOfACommonPeriod) {
  Builder make;
  NodeId sum = make.input(0);
  for (std::uint32_t k = 1; k <= 60; ++k) {
    NodeId const x = make.input(k);
    NodeId const a = make(Op::mul, x, make.number(1.5 + k % 3)), b = make(Op::mul, x, make.number(0.25 + k % 2));
    sum = make(Op::add, make(Op::mul, make(Op::add, make(Op::add, sum, a), b), x), make.number(0.5));
  }
  Graph const graph = make.finish({sum});
  Looped const result = looped(graph);
  auto const table = std::ranges::find(result.loop().leaves, Array::values, &Leaf::array);
  ASSERT_NE(table, result.loop().leaves.end());
  EXPECT_EQ(table->values.size(), 6);
}

// The squares of sine and cosine of one angle add up to 1.
TEST(Bodies, SineAndCosineAreThoseOfOneAngle) {
  Builder make;
  NodeId sum = make.input(0);
  for (std::uint32_t k = 1; k <= 60; ++k) {
    NodeId const s = make(Op::sin, make.input(k)), c = make(Op::cos, make.input(k)), y = make(Op::mul, sum, c);
    NodeId const squares = make(Op::add, make(Op::mul, s, s), make(Op::mul, c, c));
    sum = make(Op::add, y, make(Op::mul, squares, make.input(k)));
  }
  Graph const graph = make.finish({sum});
  Looped const result = looped(graph);
  EXPECT_EQ(result.operations(), 2);
  EXPECT_EQ(result.leaves(Array::sine), 0);
  EXPECT_EQ(result.leaves(Array::cosine), 1);
  EXPECT_EQ(result.leaves(Array::input), 1);
}

// Two loops of equal bodies, whose tables differ.
TEST(Bodies, EqualBodiesAreSearchedOnce) {
  Builder make;
  std::vector<NodeId> results;
  for (std::uint32_t row = 0; row < 2; ++row) {
    NodeId sum = make(Op::exp, make.input(row));
    for (std::uint32_t k = 1; k <= 60; ++k)
      sum = make(Op::mul, make(Op::add, sum, make.number(k * k + row)), make.input(k + 1));
    results.push_back(sum);
  }
  Graph const graph = make.finish(results);
  Plan const plan = schedule(graph);
  int loops = 0;
  auto const counted = [&](Graph body, bool in_loop) {
    loops += in_loop;
    return by_passes(std::move(body), in_loop);
  };
  Rerolled const found = improved(rerolled(plan, FloatingPoint::fast), plan.angles, counted);
  EXPECT_EQ(found.functions.at(FunctionKind::compute).loops, 2);
  EXPECT_EQ(loops, 1);
}

// What is carried only to carry itself on is left out.
TEST(Bodies, WhatNobodyReadsAnyMoreIsNotCarried) {
  Builder make;
  NodeId sum = make.input(0), other = make.input(1);
  for (std::uint32_t k = 2; k < 62; ++k) {
    other = make(Op::mul, make(Op::add, other, make.input(k)), make.number(0.5));
    sum = make(Op::add, make(Op::mul, sum, make.input(k)),
               make(Op::sub, make(Op::mul, other, sum), make(Op::mul, sum, other)));
  }
  Graph const graph = make.finish({sum});
  Looped const result = looped(graph);
  EXPECT_EQ(result.operations(), 1);
  EXPECT_EQ(std::ranges::count(result.loop().leaves, true, &Leaf::is_carried), 1);
}

// A sum to which nothing is added any more, beside one that is carried on.
TEST(Bodies, WhatNeverChangesIsCarriedOn) {
  Builder make;
  NodeId sum = make(Op::exp, make.input(0)), other = make(Op::exp, make.input(1));
  for (std::uint32_t k = 2; k < 62; ++k) {
    NodeId const x = make.input(k), y = make(Op::add, x, make.number(1));
    sum = make(Op::add, sum, make(Op::sub, make(Op::mul, x, y), make(Op::mul, y, x)));
    other = make(Op::add, make(Op::mul, make(Op::add, other, x), make.number(0.5)), sum);
  }
  Graph const graph = make.finish({sum, other});
  EXPECT_EQ(looped(graph).operations(), 3);
}

} // namespace
} // namespace symreal
