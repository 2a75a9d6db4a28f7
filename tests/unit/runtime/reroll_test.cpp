// What --reroll finds in small graphs, and that its proof sees a fault. The proof runs in every rerolled().
#include "engine/plan/reroll/check.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"
#include "graph_builder.h"
#include "loop_run.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace symreal {
namespace {

using Builder = test::GraphBuilder;
using reroll::Leaf;
using reroll::LoopFunction;
using reroll::LoopStep;

LoopFunction compute_of(Graph const &graph) {
  Rerolled const loops = rerolled(schedule(graph), FloatingPoint::strict);
  EXPECT_TRUE(loops.functions.contains(FunctionKind::compute)) << loops.why_not;
  return test::loops_of_compute(loops).value_or(LoopFunction());
}

LoopStep const &longest(LoopFunction const &function) {
  return *std::ranges::max_element(function.steps, {},
                                   [](LoopStep const &step) { return step.count * step.body.nodes.size(); });
}

std::vector<Leaf> leaves_of(LoopStep const &step, Array array, bool is_carried = false) {
  std::vector<Leaf> found;
  std::ranges::copy_if(step.leaves, std::back_inserter(found),
                       [&](Leaf const &leaf) { return leaf.array == array && leaf.is_carried == is_carried; });
  return found;
}

// y[k] = 0.25 x[k] + 0.5 y[k - 1]
Graph filter(std::uint32_t samples) {
  Builder make;
  std::vector<NodeId> y = {make(Op::mul, make.input(0), make.number(0.25))};
  for (std::uint32_t k = 1; k < samples; ++k)
    y.push_back(
        make(Op::add, make(Op::mul, make.input(k), make.number(0.25)), make(Op::mul, y.back(), make.number(0.5))));
  return make.finish(y);
}

TEST(Reroll, AFilterCarriesItsState) {
  LoopFunction const function = compute_of(filter(100));
  EXPECT_EQ(function.loops, 1);
  LoopStep const &loop = longest(function);
  EXPECT_GE(loop.count, 95);
  EXPECT_EQ(leaves_of(loop, Array::memory, true).size(), 1);
  std::vector<Leaf> const given = leaves_of(loop, Array::input);
  ASSERT_EQ(given.size(), 1);
  EXPECT_EQ(given[0].access.step, 1);
  EXPECT_TRUE(leaves_of(loop, Array::values).empty());
}

// y[k] = x[k] + 0.5 y[k - 1] - 0.25 y[k - 2]
TEST(Reroll, AFilterOfSecondOrderReadsNoStateFromMemory) {
  Builder make;
  std::vector<NodeId> y = {make.input(0), make.input(1)};
  for (std::uint32_t k = 2; k < 100; ++k) {
    NodeId const sum = make(Op::add, make.input(k), make(Op::mul, y[k - 1], make.number(0.5)));
    y.push_back(make(Op::sub, sum, make(Op::mul, y[k - 2], make.number(0.25))));
  }
  LoopStep const loop = longest(compute_of(make.finish(y)));
  EXPECT_EQ(leaves_of(loop, Array::memory, true).size(), 2);
  EXPECT_TRUE(leaves_of(loop, Array::memory).empty());
  ASSERT_EQ(loop.stores.size(), 1);
  EXPECT_EQ(loop.stores[0].access.step, 1);
}

// Two sums of a*cos(b + c*t). Every now and then the second has a factor c that the first has, too.
Graph two_series(std::uint32_t terms) {
  Builder make;
  NodeId const t = make(Op::mul, make.input(0), make.input(0));
  auto const sum = [&](double first, auto const &factor_of) {
    NodeId result = make.input(1);
    for (std::uint32_t k = 0; k < terms; ++k) {
      NodeId const phase = make(Op::add, make.number(first + 0.25 * k), make(Op::mul, t, make.number(factor_of(k))));
      result = make(Op::add, result, make(Op::mul, make.number(first - 0.125 * k), make(Op::cos, phase)));
    }
    return result;
  };
  auto const own = [](std::uint32_t k) { return 3.0 + 0.0625 * k; };
  NodeId const one = sum(100.0, own);
  NodeId const other = sum(200.0, [&](std::uint32_t k) { return k * k % 7 < 3 ? own(k) : 1000.0 + k; });
  return make.finish({one, other});
}

TEST(Reroll, TermsComputeWhatTheyShare) {
  LoopFunction const function = compute_of(two_series(100));
  EXPECT_EQ(function.loops, 2);
  EXPECT_GE(function.in_loops + 15, function.operations); // the first terms of each are apart
  EXPECT_GT(function.operations, 950);                    // 5 of each term, and the square
}

TEST(Reroll, ASumOverwritesTheOneBefore) {
  LoopFunction const function = compute_of(two_series(100));
  LoopStep const &loop = longest(function);
  ASSERT_EQ(loop.stores.size(), 1);
  EXPECT_EQ(loop.stores[0].access.step, 0);
  EXPECT_LT(function.memory, 10);
}

TEST(Reroll, TheStepsDoNotGrowWithTheSamples) {
  LoopFunction const few = compute_of(filter(100)), many = compute_of(filter(1000));
  EXPECT_EQ(few.steps.size(), many.steps.size());
  EXPECT_EQ(few.operations - few.in_loops, many.operations - many.in_loops);
}

// Of two nested loops the inner ones, longer from row to row, each a small part of all: y = 0.5 y + x.
TEST(Reroll, ManyLoopsMayEachBeASmallPart) {
  Builder make;
  std::vector<NodeId> results;
  for (std::uint32_t row = 0; row < 60; ++row) {
    NodeId y = make(Op::exp, make.input(row));
    for (std::uint32_t k = 0; k < 160 + row; ++k)
      y = make(Op::add, make(Op::mul, y, make.number(0.5)), make.input(60 + row + k));
    results.push_back(make(Op::sin, y));
  }
  LoopFunction const function = compute_of(make.finish(results));
  EXPECT_GE(function.loops, 59);
  EXPECT_GT(function.in_loops, function.operations * 9 / 10);
}

TEST(Reroll, CoefficientsAreATable) {
  Builder make;
  NodeId sum = make.input(0);
  NodeId const x = make.input(1);
  for (int k = 0; k < 60; ++k) sum = make(Op::add, make(Op::mul, sum, x), make.number(1 + k * k));
  LoopStep const loop = longest(compute_of(make.finish({sum})));
  EXPECT_GE(loop.count, 55);
  std::vector<Leaf> const values = leaves_of(loop, Array::values);
  ASSERT_EQ(values.size(), 1);
  EXPECT_EQ(values[0].values.size(), loop.count);
}

TEST(Reroll, ATableIsAsLongAsItsPeriod) {
  Builder make;
  NodeId sum = make.input(0);
  for (int k = 0; k < 60; ++k) sum = make(Op::add, make(Op::mul, sum, make.input(1)), make.number(2 + k % 5));
  std::vector<Leaf> const values = leaves_of(longest(compute_of(make.finish({sum}))), Array::values);
  ASSERT_EQ(values.size(), 1);
  EXPECT_EQ(values[0].values.size(), 5);
}

TEST(Reroll, ASignGoesIntoAConstant) {
  Builder make;
  NodeId sum = make.input(0);
  for (std::uint32_t k = 0; k < 60; ++k)
    sum = make(k * k % 7 < 3 ? Op::add : Op::sub, sum, make(Op::mul, make.input(k), make.number(2 + k)));
  LoopStep const loop = longest(compute_of(make.finish({sum})));
  ASSERT_EQ(leaves_of(loop, Array::values).size(), 1);
  std::vector<double> const values = leaves_of(loop, Array::values)[0].values;
  EXPECT_TRUE(std::ranges::any_of(values, [](double value) { return value < 0; }));
}

TEST(Reroll, ASignThatHasNoConstantIsAFactor) {
  Builder make;
  NodeId sum = make.input(0);
  for (std::uint32_t k = 0; k < 60; ++k)
    sum = make(k * k % 7 < 3 ? Op::add : Op::sub, make(Op::mul, sum, make.number(0.5)), make.input(k));
  std::vector<Leaf> const values = leaves_of(longest(compute_of(make.finish({sum}))), Array::values);
  ASSERT_EQ(values.size(), 1);
  for (double value : values[0].values) EXPECT_EQ(std::abs(value), 1);
}

// Steps of the classical method of Runge and Kutta for y' = -sin y.
TEST(Reroll, ARungeKuttaStepIsABody) {
  Builder make;
  NodeId y = make.input(0);
  NodeId const h = make.input(1), half = make(Op::mul, h, make.number(0.5)), sixth = make(Op::div, h, make.number(6));
  auto const slope = [&](NodeId at) { return make(Op::neg, make(Op::sin, at)); };
  auto const moved = [&](NodeId by, NodeId k) { return make(Op::add, y, make(Op::mul, by, k)); };
  for (int step = 0; step < 50; ++step) {
    NodeId const k1 = slope(y), k2 = slope(moved(half, k1)), k3 = slope(moved(half, k2)), k4 = slope(moved(h, k3));
    NodeId const inner = make(Op::mul, make.number(2), make(Op::add, k2, k3));
    y = make(Op::add, y, make(Op::mul, sixth, make(Op::add, make(Op::add, k1, inner), k4)));
  }
  LoopFunction const function = compute_of(make.finish({y}));
  EXPECT_EQ(function.loops, 1);
  EXPECT_GE(longest(function).count, 47);
  EXPECT_EQ(leaves_of(longest(function), Array::memory, true).size(), 1);
}

// As the two sweeps over a chain: what the first stores, the second reads in reverse.
TEST(Reroll, ASecondSweepReadsBackwards) {
  Builder make;
  std::vector<NodeId> forward;
  NodeId v = make.input(0);
  for (std::uint32_t k = 1; k <= 80; ++k) {
    v = make(Op::add, make(Op::mul, v, make(Op::cos, make.input(k))), make(Op::sin, make.input(k)));
    forward.push_back(v);
  }
  NodeId force = make.input(0);
  std::vector<NodeId> results;
  for (std::uint32_t k = 80; k-- > 0;) {
    force = make(Op::add, make(Op::mul, force, make.number(0.5)), make(Op::mul, forward[k], forward[k]));
    results.push_back(force);
  }
  LoopFunction const function = compute_of(make.finish(results));
  EXPECT_EQ(function.loops, 2);
  std::size_t backwards = 0;
  for (LoopStep const &step : function.steps)
    for (Leaf const &leaf : step.leaves) {
      EXPECT_FALSE(leaf.access.is_listed());
      backwards += leaf.array == Array::memory && leaf.access.step < 0;
    }
  EXPECT_EQ(backwards, 1);
}

// What stands before the first iteration is copied to where the loop looks for it.
TEST(Reroll, IterationsFurtherBackAreRecords) {
  Builder make;
  std::vector<NodeId> y;
  for (std::uint32_t k = 0; k < 5; ++k) y.push_back(make(Op::sin, make.input(k)));
  for (std::uint32_t k = 5; k < 60; ++k)
    y.push_back(make(Op::add, make(Op::mul, y[k - 1], make.input(k)), make(Op::mul, y[k - 5], make.number(0.5))));
  LoopStep const loop = longest(compute_of(make.finish({y.back()})));
  EXPECT_GE(loop.count, 50);
  EXPECT_EQ(leaves_of(loop, Array::memory).size(), 1);
}

TEST(Reroll, AnIrregularOrderIsAList) {
  Builder make;
  std::vector<NodeId> first;
  for (std::uint32_t k = 0; k < 64; ++k) first.push_back(make(Op::exp, make(Op::sin, make.input(k))));
  NodeId sum = make.input(0);
  for (std::uint32_t k = 0; k < 64; ++k) sum = make(Op::add, make(Op::mul, sum, make.number(0.5)), first[k * k % 61]);
  LoopFunction const function = compute_of(make.finish({sum}));
  EXPECT_TRUE(std::ranges::any_of(function.steps, [](LoopStep const &step) {
    return std::ranges::any_of(step.leaves, [](Leaf const &leaf) { return leaf.access.is_listed(); });
  }));
}

// All iterations use what the first one computes: that one stays outside.
TEST(Reroll, WhatTheFirstIterationComputesForAll) {
  Builder make;
  NodeId sum = make.input(0), shared = no_node;
  for (std::uint32_t k = 1; k < 60; ++k) {
    NodeId const here = make(Op::sin, make.input(k));
    if (k == 1) shared = here;
    sum = make(Op::add, make(Op::mul, sum, shared), here);
  }
  EXPECT_GE(longest(compute_of(make.finish({sum}))).count, 50);
}

TEST(Reroll, ResultsAndGuardsOfEveryKind) {
  Builder make;
  NodeId sum = make.input(0);
  for (std::uint32_t k = 1; k < 60; ++k) sum = make(Op::add, make(Op::mul, sum, make.number(0.5)), make.input(k));
  NodeId const guard = make(Op::lt, make.number(0), sum);
  LoopFunction const function = compute_of(make.finish({sum, make.number(7), make.input(3), sum}, {guard}));
  EXPECT_EQ(function.checks.size(), 1);
}

TEST(Reroll, WithoutRepeatsThereAreNoLoops) {
  Builder make;
  NodeId const sum = make(Op::add, make(Op::sin, make.input(0)), make.input(1));
  Rerolled const loops = rerolled(schedule(make.finish({sum})), FloatingPoint::strict);
  EXPECT_FALSE(loops.has_loops());
  EXPECT_EQ(loops.why_not, "no operations repeat often enough");
}

// Every number of every step that changes what is computed changes the proof.
TEST(Reroll, TheProofSeesAFault) {
  Graph const graph = filter(100);
  Plan const plan = schedule(graph);
  reroll::Sequence const all = reroll::sequence(plan, FunctionKind::compute, graph.results);
  LoopFunction const good = compute_of(graph);
  EXPECT_EQ(reroll::find_difference(all, good, graph.results, {}), "");
  auto const is_seen = [&](auto const &change) {
    LoopFunction bad = good;
    change(bad);
    return !reroll::find_difference(all, bad, graph.results, {}).empty();
  };
  std::size_t const loop = static_cast<std::size_t>(&longest(good) - good.steps.data());
  EXPECT_TRUE(is_seen([&](LoopFunction &bad) { --bad.steps[loop].count; }));
  EXPECT_TRUE(is_seen([&](LoopFunction &bad) { bad.steps[loop].stores[0].access.step = 0; }));
  EXPECT_TRUE(is_seen([&](LoopFunction &bad) { std::swap(bad.steps[loop], bad.steps.back()); }));
  for (std::size_t k = 0; k < good.steps[loop].leaves.size(); ++k) {
    EXPECT_TRUE(is_seen([&](LoopFunction &bad) { bad.steps[loop].leaves[k].access.first ^= 1; }));
    if (good.steps[loop].leaves[k].array == Array::input)
      EXPECT_TRUE(is_seen([&](LoopFunction &bad) { bad.steps[loop].leaves[k].access.step = 2; }));
  }
  for (std::size_t id = 0; id < good.steps[loop].body.nodes.size(); ++id)
    if (good.steps[loop].body.nodes[id].op == Op::add)
      EXPECT_TRUE(is_seen([&](LoopFunction &bad) { bad.steps[loop].body.nodes[id].op = Op::sub; }));
}

} // namespace
} // namespace symreal
