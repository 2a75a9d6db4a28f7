// What --vector finds in small graphs, and that its proof sees a fault. The proof runs in every laned().
#include "engine/plan/lanes/check.h"
#include "engine/plan/lanes/lanes.h"
#include "engine/plan/schedule/schedule.h"
#include "graph_builder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace symreal {
namespace {

using Builder = test::GraphBuilder;
using lanes::LaneFunction;
using lanes::Vector;

LaneFunction compute_of(Graph const &graph, std::size_t width = 4) {
  Laned const lanes = laned(schedule(graph), width);
  EXPECT_TRUE(lanes.compute) << lanes.why_not;
  return lanes.compute.value_or(LaneFunction());
}

std::size_t count(LaneFunction const &function, Vector::Form form) {
  return static_cast<std::size_t>(std::ranges::count(function.vectors, form, &Vector::form));
}

// y = x * x[8] + 0.5 for 4 elements of x, in this order
Graph scaled(std::vector<std::uint32_t> const &order) {
  Builder make;
  std::vector<NodeId> y;
  for (std::uint32_t k : order)
    y.push_back(make(Op::add, make(Op::mul, make.input(k), make.input(8)), make.number(0.5)));
  return make.finish(y);
}

TEST(Lanes, WhatStandsSideBySideIsLoadedAndStored) {
  LaneFunction const function = compute_of(scaled({2, 3, 4, 5}));
  EXPECT_EQ(count(function, Vector::Form::operation), 2U);
  EXPECT_EQ(count(function, Vector::Form::load), 1U);
  EXPECT_EQ(count(function, Vector::Form::splat), 1U);
  EXPECT_EQ(count(function, Vector::Form::shuffle), 0U);
  EXPECT_EQ(function.stores.size(), 1U);
  EXPECT_EQ(function.in_lanes, 8U);
  EXPECT_EQ(function.operations, 8U);
}

TEST(Lanes, WhatStandsInAnotherOrderIsShuffled) {
  LaneFunction const function = compute_of(scaled({1, 2, 3, 0}));
  ASSERT_EQ(count(function, Vector::Form::shuffle), 1U);
  auto const shuffle = std::ranges::find(function.vectors, Vector::Form::shuffle, &Vector::form);
  EXPECT_EQ(shuffle->from, (std::vector<std::uint32_t>{1, 2, 3, 0}));
  EXPECT_EQ(function.in_lanes, 8U);
}

TEST(Lanes, ASumThatIsADifferenceInSomeLanesIsOneOperation) {
  Builder make;
  std::vector<NodeId> y;
  for (std::uint32_t k = 0; k < 4; ++k)
    y.push_back(make(k % 2 == 0 ? Op::add : Op::sub, make.input(k), make.input(k + 4)));
  LaneFunction const function = compute_of(make.finish(y));
  ASSERT_EQ(count(function, Vector::Form::operation), 1U);
  auto const sum = std::ranges::find(function.vectors, Vector::Form::operation, &Vector::form);
  EXPECT_EQ(sum->op, Op::add);
  EXPECT_EQ(sum->subtracts, (std::vector<char>{0, 1, 0, 1}));
}

TEST(Lanes, OperandsOfProductsAreExchangedToMatch) {
  Builder make;
  std::vector<NodeId> y;
  for (std::uint32_t k = 0; k < 4; ++k)
    y.push_back(k % 2 == 0 ? make(Op::mul, make.input(k), make.input(k + 4))
                           : make(Op::mul, make.input(k + 4), make.input(k)));
  EXPECT_EQ(count(compute_of(make.finish(y)), Vector::Form::load), 2U);
}

// Four sums that one result needs, so that no results stand side by side.
TEST(Lanes, OperationsOfOneShapeAreFoundWithoutResults) {
  Builder make;
  std::vector<NodeId> sums;
  for (std::uint32_t k = 0; k < 4; ++k) {
    NodeId sum = make(Op::mul, make.input(k), make.input(32));
    for (std::uint32_t j = 1; j < 8; ++j)
      sum = make(Op::add, sum, make(Op::mul, make.input(4 * j + k), make.input(32 + j)));
    sums.push_back(sum);
  }
  NodeId result = sums[0];
  for (std::size_t k = 1; k < 4; ++k) result = make(Op::div, result, sums[k]);
  LaneFunction const function = compute_of(make.finish({result}));
  EXPECT_EQ(function.in_lanes, 60U);
  EXPECT_EQ(count(function, Vector::Form::load), 8U);
}

TEST(Lanes, WhatIsNotWorthItStaysAlone) {
  Builder make;
  NodeId const x = make.input(0), y = make.input(1);
  Laned const chain = laned(schedule(make.finish({make(Op::mul, make(Op::add, x, y), y)})), 4);
  EXPECT_FALSE(chain.compute);
  EXPECT_EQ(chain.why_not, "no operations are worth computing side by side");
}

TEST(Lanes, AChainOfOneOperationIsNoVector) {
  Builder make;
  std::vector<NodeId> y = {make(Op::mul, make.input(0), make.input(1))};
  for (int k = 0; k < 7; ++k) y.push_back(make(Op::mul, y.back(), make.input(1)));
  EXPECT_FALSE(laned(schedule(make.finish(y)), 4).compute);
}

// Sums and products of arrays in any order of their elements, with single numbers among them.
Graph random_arrays(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Builder make;
  std::vector<std::vector<NodeId>> arrays;
  for (std::uint32_t k = 0; k < 3; ++k) {
    arrays.emplace_back();
    for (std::uint32_t i = 0; i < 8; ++i) arrays.back().push_back(make.input(8 * k + i));
  }
  for (int k = 0; k < 12; ++k) {
    std::vector<NodeId> x = arrays[random() % arrays.size()], y = arrays[random() % arrays.size()], z;
    if (random() % 2 == 0) std::ranges::rotate(y, y.begin() + static_cast<std::ptrdiff_t>(random() % 8));
    if (random() % 4 == 0) std::ranges::shuffle(x, random);
    if (random() % 4 == 0) std::ranges::fill(x, x[random() % 8]);
    Op const op = std::array{Op::add, Op::sub, Op::mul, Op::div, Op::neg, Op::sin}[random() % 6];
    bool const mixes = op == Op::add && random() % 2 == 0;
    for (std::size_t i = 0; i < 8; ++i) {
      bool const swaps = op != Op::sub && op != Op::div && random() % 4 == 0;
      NodeId const a = swaps ? y[i] : x[i], b = swaps ? x[i] : y[i];
      z.push_back(arity(op) == 1 ? make(op, a) : make(mixes && random() % 2 == 0 ? Op::sub : op, a, b));
    }
    arrays.push_back(z);
  }
  std::vector<NodeId> results;
  for (std::size_t k = 1; k <= 4; ++k)
    results.insert(results.end(), arrays[arrays.size() - k].begin(), arrays[arrays.size() - k].end());
  return make.finish(results);
}

// With each width, and then with a fault in each place that an emitter reads.
TEST(Lanes, TheProofSeesAFault) {
  std::size_t faults = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Graph const graph = random_arrays(seed);
    Plan const plan = schedule(graph);
    std::size_t const width = std::array{2, 4, 8}[seed % 3];
    LaneFunction const function = laned(plan, width).compute.value_or(LaneFunction());
    lanes::ScalarFunction const of(plan, width);
    auto const expect_fault = [&](auto const &spoil) {
      LaneFunction wrong = function;
      if (!spoil(wrong)) return;
      ++faults;
      EXPECT_NE(find_difference(of, wrong), "") << seed;
    };
    // Other nodes may have the same value: x * y and y * x.
    auto const differ = [&](NodeId x, NodeId y) {
      if (x == no_node || y == no_node || x == y) return false;
      Op const a = graph.nodes[x].op, b = graph.nodes[y].op;
      return a != b || (a == Op::input && b == Op::input);
    };
    for (lanes::VectorId id = 0; id < function.vectors.size(); ++id) {
      bool const is_needed =
          std::ranges::any_of(function.order, [&](lanes::Item const &item) { return item.is_vector && item.id == id; });
      if (!is_needed) continue;
      expect_fault([&](LaneFunction &wrong) {
        Vector &vector = wrong.vectors[id];
        bool const is_sum = vector.form == Vector::Form::operation && vector.op == Op::add;
        if (is_sum) vector.op = Op::mul;
        return is_sum;
      });
      expect_fault([&](LaneFunction &wrong) {
        Vector &vector = wrong.vectors[id];
        if (vector.subtracts.empty()) return false;
        vector.subtracts[0] = vector.subtracts[0] == 0;
        return true;
      });
      expect_fault([&](LaneFunction &wrong) {
        Vector &vector = wrong.vectors[id];
        bool const is_used = vector.form == Vector::Form::load && vector.nodes[0] != no_node;
        if (is_used) ++vector.first;
        return is_used;
      });
      expect_fault([&](LaneFunction &wrong) {
        Vector &vector = wrong.vectors[id];
        if (vector.form != Vector::Form::shuffle || !differ(vector.nodes[0], vector.nodes[1])) return false;
        std::swap(vector.from[0], vector.from[1]);
        return true;
      });
    }
    expect_fault([&](LaneFunction &wrong) {
      if (wrong.stores.size() < 2) return false;
      if (!differ(graph.results[wrong.stores[0].first], graph.results[wrong.stores[1].first])) return false;
      std::swap(wrong.stores[0].first, wrong.stores[1].first);
      return true;
    });
    expect_fault([&](LaneFunction &wrong) {
      std::ranges::reverse(wrong.order);
      return wrong.order.size() > 1;
    });
  }
  EXPECT_GT(faults, 300U);
}

} // namespace
} // namespace symreal
