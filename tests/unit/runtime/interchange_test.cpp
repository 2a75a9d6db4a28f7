// Chains that wait for themselves become loops whose iterations wait for nothing, and what they store shares places.
#include "engine/plan/reroll/bodies.h"
#include "engine/plan/reroll/interchange.h"
#include "engine/plan/reroll/memory.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"
#include "graph_builder.h"
#include "loop_run.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace symreal {
namespace {

using Builder = test::GraphBuilder;
using reroll::Block;
using reroll::Leaf;
using reroll::LoopFunction;
using reroll::LoopStep;
using reroll::Storage;

constexpr std::uint32_t count = 40; // of chains

// Chain i turns a vector by angle i, i - 1, ..., 0, of which the inputs are the cosine and the sine. Where it `flips`,
// it computes with the negative of the second coordinate. `waits`: a chain begins with what the one before ends with.
// `looks_back`: when all chains are done, second coordinates are read that angle 10 has turned.
Graph turned_vectors(std::uint32_t flips, bool waits = false, bool looks_back = false) {
  Builder make;
  std::vector<NodeId> results, between;
  for (std::uint32_t i = 0; i < count; ++i) {
    bool const flipped = flips != 0 && i % flips == 1;
    NodeId x = make(Op::sqrt, make.input(2 * count + i)), y = make(Op::exp, make.input(2 * count + i));
    if (waits && !results.empty()) x = results.back();
    for (std::uint32_t k = i + 1; k-- > 0;) {
      NodeId const c = make.input(2 * k), s = make.input(2 * k + 1);
      NodeId const xc = make(Op::mul, x, c), xs = make(Op::mul, x, s), yc = make(Op::mul, y, c),
                   ys = make(Op::mul, y, s);
      x = make(flipped ? Op::add : Op::sub, xc, ys);
      y = flipped ? make(Op::sub, yc, xs) : make(Op::add, xs, yc);
      results.push_back(x);
      if (looks_back && k == 10) between.push_back(y);
    }
  }
  for (NodeId const y : between) results.push_back(make(Op::sqrt, y));
  return make.finish(results);
}

LoopFunction compute_of(Graph const &graph, FloatingPoint mode = FloatingPoint::strict) {
  Rerolled const loops = rerolled(schedule(graph), mode);
  EXPECT_TRUE(loops.functions.contains(FunctionKind::compute)) << loops.why_not;
  return test::loops_of_compute(loops).value_or(LoopFunction());
}

template <class Value> bool any_leaf(LoopFunction const &function, Value Leaf::*field, Value value) {
  return std::ranges::any_of(function.steps, [&](LoopStep const &step) {
    return step.count > 1 && std::ranges::any_of(step.leaves, [&](Leaf const &leaf) { return leaf.*field == value; });
  });
}

TEST(Interchange, StagesOfAllChainsAreRows) {
  LoopFunction const function = compute_of(turned_vectors(0));
  EXPECT_LE(function.loops, 3);
  EXPECT_GT(function.in_loops, function.operations * 9 / 10);
  EXPECT_FALSE(any_leaf(function, &Leaf::is_carried, true));
  EXPECT_FALSE(any_leaf(function, &Leaf::array, Array::values));
  auto const rows = std::ranges::find_if(function.steps, [](LoopStep const &step) { return step.nest.has_value(); });
  ASSERT_NE(rows, function.steps.end());
  EXPECT_EQ(rows->nest->growth, 1);
  EXPECT_GE(rows->nest->turns, 35);
}

TEST(Interchange, WhereSomebodyLooksBackEachStageIsALoop) {
  LoopFunction const function = compute_of(turned_vectors(0, false, true));
  EXPECT_GE(function.loops, 30);
  EXPECT_GT(function.in_loops, function.operations * 9 / 10);
  EXPECT_FALSE(any_leaf(function, &Leaf::is_carried, true));
  EXPECT_FALSE(any_leaf(function, &Leaf::array, Array::values));
  // Where compilers may carry out iterations at the same time, neighbours stand beside each other.
  auto const is_one = [](auto const &element) { return element.access.step == 1; };
  auto const stores_beside = [&](LoopStep const &step) {
    return reroll::operations_of(step.body) >= 6 && std::ranges::all_of(step.stores, is_one);
  };
  EXPECT_GE(std::ranges::count_if(function.steps, stores_beside), 30);
}

// All first coordinates are results; of the second ones two stages are alive at the same time.
TEST(Interchange, StagesLeaveTheirPlaces) {
  LoopFunction const function = compute_of(turned_vectors(0));
  EXPECT_LT(function.memory, count * (count + 1) * 4 / 5);
}

TEST(Interchange, AChainThatWaitsForAnotherStays) {
  LoopFunction const function = compute_of(turned_vectors(0, true));
  EXPECT_TRUE(any_leaf(function, &Leaf::is_carried, true));
}

// What a chain begins with is stored as its negative, once, and no iteration needs a factor.
TEST(Interchange, SignsOfChainsAreThoseOfTheirBeginnings) {
  Graph const graph = turned_vectors(3);
  LoopFunction const before = compute_of(graph), after = compute_of(graph, FloatingPoint::finite);
  EXPECT_TRUE(any_leaf(before, &Leaf::array, Array::values));
  EXPECT_FALSE(any_leaf(after, &Leaf::array, Array::values));
  std::vector<double> inputs;
  for (std::size_t k = 0; k < graph.input_count(); ++k) inputs.push_back(1.5 + std::sin(static_cast<double>(k * k)));
  std::vector<double> const values = evaluate(graph, inputs, {}),
                            run = test::run(after, {}, inputs, graph.results.size());
  for (std::size_t k = 0; k < graph.results.size(); ++k) EXPECT_EQ(run[k], values[graph.results[k]]);
}

bool live_together(Block const &a, Block const &b) {
  return a.life.first <= b.life.last && b.life.first <= a.life.last;
}

TEST(Storage, BlocksThatLiveTogetherShareNothing) {
  std::mt19937 random(3);
  auto const below = [&](unsigned limit) { return std::uniform_int_distribution<unsigned>(0, limit - 1)(random); };
  for (int sample = 0; sample < 50; ++sample) {
    std::vector<Block> blocks;
    std::size_t sum = 0;
    for (int k = 0; k < 100; ++k) {
      std::uint32_t const first = below(100);
      blocks.push_back({1 + below(20), {first, first + below(10)}});
      sum += blocks.back().size;
    }
    Storage const storage = reroll::stored(blocks);
    EXPECT_LT(storage.size, sum / 3);
    for (std::size_t a = 0; a < blocks.size(); ++a) {
      EXPECT_LE(storage.begins[a] + blocks[a].size, storage.size);
      for (std::size_t b = 0; b < a; ++b) {
        bool const overlap = storage.begins[a] < storage.begins[b] + blocks[b].size &&
                             storage.begins[b] < storage.begins[a] + blocks[a].size;
        EXPECT_FALSE(overlap && live_together(blocks[a], blocks[b]));
      }
    }
  }
}

} // namespace
} // namespace symreal
