// Who stores the results of a function of loops: the loops themselves, copies at the end, or a mirror.
#include "engine/graph/evaluate.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"
#include "graph_builder.h"
#include "loop_run.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace symreal {
namespace {

using Builder = test::GraphBuilder;
using reroll::LoopFunction;
using reroll::LoopStep;
using reroll::Store;

constexpr std::uint32_t rows = 20;

struct Squares {
  Builder make;
  std::vector<NodeId> z; // what has read all inputs

  Squares() {
    NodeId sum = make.input(0);
    for (std::uint32_t k = 1; k < rows; ++k) sum = make(Op::add, make(Op::mul, sum, make.number(0.5)), make.input(k));
    z.push_back(sum);
    for (std::uint32_t k = 1; k < rows; ++k) z.push_back(make(Op::sqrt, make(Op::exp, z.back())));
  }

  NodeId product(std::uint32_t i, std::uint32_t j) {
    return make(Op::mul, make(Op::add, z[i], make(Op::mul, z[j], make.number(2))), make(Op::exp, z[j]));
  }

  // Rows of the half above the diagonal one after the other, or its columns; the other half is the same.
  std::vector<NodeId> symmetric(bool by_rows) {
    std::vector<NodeId> matrix(std::size_t{rows} * rows);
    for (std::uint32_t i = 0; i < rows; ++i)
      for (std::uint32_t j = by_rows ? i : 0; j < (by_rows ? rows : i + 1); ++j)
        matrix[i * rows + j] = matrix[j * rows + i] = product(i, j);
    return matrix;
  }
};

LoopFunction compute_of(Graph const &graph) {
  Plan const plan = schedule(graph);
  Rerolled const loops = rerolled(plan, FloatingPoint::strict);
  std::optional<LoopFunction> const found = test::loops_of_compute(loops);
  EXPECT_TRUE(found) << loops.why_not;
  if (!found) return {};
  std::vector<double> inputs;
  for (std::uint32_t k = 0; k < rows; ++k) inputs.push_back(0.01 * k);
  std::vector<double> const values = evaluate(graph, inputs, {});
  std::vector<double> const results = test::run(*found, {}, inputs, graph.results.size());
  for (std::size_t k = 0; k < results.size(); ++k) EXPECT_EQ(results[k], values[graph.results[k]]) << k;
  return *found;
}

bool stores_results(LoopStep const &step) { return std::ranges::any_of(step.stores, &Store::is_result); }

bool computes(LoopStep const &step) {
  return std::ranges::any_of(step.body.nodes, [](Node const &node) { return !is_leaf(node.op); });
}

bool a_loop_stores_results(LoopFunction const &function) {
  return std::ranges::any_of(
      function.steps, [](LoopStep const &step) { return step.count > 1 && computes(step) && stores_results(step); });
}

TEST(LoopResults, LoopsStoreThemBehindTheLastInput) {
  Squares squares;
  LoopFunction const function = compute_of(squares.make.finish(squares.symmetric(true)));
  EXPECT_TRUE(a_loop_stores_results(function));
  auto const first = std::ranges::find_if(function.steps, stores_results);
  EXPECT_TRUE(std::none_of(first, function.steps.end(), reroll::reads_arguments));
}

TEST(LoopResults, WhileInputsAreReadTheyWait) {
  Squares squares;
  std::vector<NodeId> results = squares.z;
  results.push_back(squares.make(Op::add, squares.z.back(), squares.make.input(0)));
  EXPECT_FALSE(a_loop_stores_results(compute_of(squares.make.finish(results))));
}

TEST(LoopResults, WhatIsCheckedIsCheckedBefore) {
  Squares squares;
  std::vector<NodeId> const results = squares.symmetric(true);
  EXPECT_FALSE(a_loop_stores_results(compute_of(squares.make.finish(results, {squares.z[1]}))));
}

TEST(LoopResults, HalfOfASymmetricMatrixIsCopied) {
  for (bool const by_rows : {true, false}) {
    Squares squares;
    LoopFunction const function = compute_of(squares.make.finish(squares.symmetric(by_rows)));
    ASSERT_EQ(function.mirrors.size(), 1);
    EXPECT_EQ(function.mirrors[0].rows, rows);
    EXPECT_EQ(function.mirrors[0].from_above, by_rows);
  }
}

TEST(LoopResults, OfSeveralMatricesEachIsLookedAt) {
  Squares squares;
  std::vector<NodeId> const matrix = squares.symmetric(true);
  std::vector<NodeId> results = {squares.z[0]};
  for (int copy = 0; copy < 2; ++copy) results.insert(results.end(), matrix.begin(), matrix.end());
  results[rows] = squares.z[3];
  Graph graph = squares.make.finish(results);
  graph.outputs = {{"y", {}, 0, 1}, {"P", {2, rows, rows}, 1, 2 * rows * rows}};
  LoopFunction const function = compute_of(graph);
  ASSERT_EQ(function.mirrors.size(), 1);
  EXPECT_EQ(function.mirrors[0].first, 1 + rows * rows);
}

} // namespace
} // namespace symreal
