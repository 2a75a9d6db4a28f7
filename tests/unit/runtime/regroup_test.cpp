// Passes that regroup sums and products keep values and work; balance never lengthens the longest path.
#include "engine/graph/evaluate.h"
#include "engine/graph/extended.h"
#include "engine/graph/graph_text.h"
#include "engine/graph/validate.h"
#include "engine/optimise/passes/pass.h"

#include "graph_builder.h"
#include "graph_words.h"
#include "random_graph.h"

#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

using test::text;

struct Figures {
  int work = 0;
  double span = 0;
};

Figures figures(Graph const &graph) {
  Figures result;
  std::vector<char> const live = live_nodes(graph);
  std::vector<double> end(graph.nodes.size(), 0);
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!live[id] || is_leaf(node.op) || node.attribute != Attribute::variable) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node) end[id] = std::max(end[id], end[operand]);
    end[id] += info(node.op).cost;
    result.work += info(node.op).cost;
    result.span = std::max(result.span, end[id]);
  }
  return result;
}

// In extended precision, so that only the order of rounding differs.
int compare(Graph const &graph, Graph const &made, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int compared = 0;
  for (int sample = 0; sample < 4; ++sample) {
    std::vector<double> x(graph.input_count()), p(graph.parameter_count());
    for (double &value : x) value = uniform(random);
    for (double &value : p) value = uniform(random);
    std::vector<double> const before = evaluate(graph, x, p), after = evaluate(made, x, p);
    if (std::ranges::any_of(before, [](double value) { return !(std::fabs(value) < 1000); })) continue;
    auto const exact = evaluate_extended(graph, x, p, before), now = evaluate_extended(made, x, p, after);
    if (!exact || !now) continue;
    for (std::size_t k = 0; k < exact->size(); ++k) {
      EXPECT_LE(std::fabs((*exact)[k] - (*now)[k]), 1e-12L) << "seed " << seed << " output " << k;
      ++compared;
    }
  }
  return compared;
}

class Regrouping : public ::testing::TestWithParam<char const *> {};

TEST_P(Regrouping, KeepsValuesAndWork) {
  std::vector<std::string> const pass = {GetParam()};
  int compared = 0, changed = 0, shorter = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    std::vector<std::string> const before = {"cull", "simplify"};
    Graph const graph = run_passes(test::random_graph(seed, 30 + seed), before, FloatingPoint::fast);
    Graph const made = run_passes(graph, pass, FloatingPoint::fast);
    ASSERT_EQ(find_violation(made), "") << seed;
    Figures const old = figures(graph), now = figures(made);
    EXPECT_LE(now.work, old.work) << seed;
    if (pass[0] == "balance") EXPECT_LE(now.span, old.span) << seed;
    compared += compare(graph, made, seed);
    changed += text(made) != text(graph);
    shorter += now.span < old.span;
    EXPECT_EQ(text(run_passes(graph, pass, FloatingPoint::fast)), text(made));
    EXPECT_EQ(text(run_passes(graph, pass, FloatingPoint::finite)), text(graph));
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(changed, 20);
  if (pass[0] == "balance") EXPECT_GT(shorter, 20);
}

INSTANTIATE_TEST_SUITE_P(Passes, Regrouping, ::testing::Values("regroup", "balance", "latency"),
                         [](auto const &parameter) { return parameter.param; });

// A sum of nine terms, one after the other, and so many other products.
Graph sum_beside(std::uint32_t products) {
  test::GraphBuilder make;
  NodeId sum = make.input(0);
  for (std::uint32_t k = 1; k < 9; ++k) sum = make(Op::add, sum, make.input(k));
  std::vector<NodeId> results = {sum};
  for (std::uint32_t k = 0; k < products; ++k) results.push_back(make(Op::mul, make.input(k), make.input(k + 1)));
  return make.finish(results);
}

TEST(Latency, SixteenOperationsBesideEachOneOfThePathAreEnough) {
  Graph const few = sum_beside(8 * 15 - 1), enough = sum_beside(8 * 15);
  std::vector<std::string> const pass = {"latency"};
  auto const span_after = [&](Graph const &graph) {
    return figures(run_passes(graph, pass, FloatingPoint::fast)).span;
  };
  EXPECT_EQ(figures(few).span, 8);
  EXPECT_EQ(span_after(few), 4);
  EXPECT_EQ(span_after(enough), 8);
}

TEST(Latency, WhatLoopsAreLookedForInStaysAlike) {
  PassSettings settings(FloatingPoint::fast);
  settings.searches = false;
  std::vector<std::string> const pass = {"latency"};
  EXPECT_EQ(figures(run_passes(sum_beside(0), pass, settings)).span, 8);
}

} // namespace
} // namespace symreal
