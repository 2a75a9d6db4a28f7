// Integer and half-integer powers as multiplications: how few, how exact, and never dearer than the calls.
#include "engine/graph/evaluate.h"
#include "engine/graph/node_table.h"
#include "engine/optimise/passes/addition_sequence.h"
#include "engine/optimise/passes/pass.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace symreal {
namespace {

void expect_leads_to(std::vector<int> const &given, std::vector<int> const &wanted, std::vector<Addition> const &made) {
  std::set<int> known(given.begin(), given.end());
  for (Addition const &addition : made) {
    EXPECT_TRUE(known.contains(addition.a) && known.contains(addition.b) && addition.a + addition.b == addition.sum);
    EXPECT_TRUE(known.insert(addition.sum).second) << "twice";
  }
  for (int number : wanted) EXPECT_TRUE(known.contains(number)) << number;
}

// The numbers of the literature: the least that take so many additions.
TEST(AdditionSequence, IsAsShortAsCanBe) {
  std::pair<int, std::size_t> const known[] = {{1, 0},  {2, 1},  {3, 2},  {5, 3},  {7, 4},  {11, 5}, {19, 6}, {29, 7},
                                               {47, 8}, {15, 5}, {23, 6}, {31, 7}, {33, 6}, {63, 8}, {64, 6}};
  for (auto const &[number, length] : known) {
    std::vector<Addition> const made = addition_sequence({1}, {number});
    expect_leads_to({1}, {number}, made);
    EXPECT_EQ(made.size(), length) << number;
  }
}

TEST(AdditionSequence, SharesSums) {
  EXPECT_EQ(addition_sequence({1}, {2, 3, 6}).size(), 3u);
  EXPECT_EQ(addition_sequence({2}, {4, 6, 12}).size(), 3u) << "the same in halves";
  EXPECT_EQ(addition_sequence({1, 2}, {1, 3, 5}).size(), 2u);
}

// Where there are too many for a search, the binary method.
TEST(AdditionSequence, OfManyNumbers) {
  std::mt19937 random(3);
  for (int round = 0; round < 30; ++round) {
    std::set<int> numbers;
    for (std::size_t count = 1 + random() % 20; numbers.size() < count;)
      numbers.insert(static_cast<int>(1 + random() % 128));
    std::vector<int> const wanted(numbers.begin(), numbers.end());
    std::vector<Addition> const made = addition_sequence({1, 2}, wanted);
    expect_leads_to({1, 2}, wanted, made);
    EXPECT_LE(made.size(), 13 * wanted.size());
  }
}

Graph powers_of_one(std::vector<double> const &exponents) {
  NodeTable table;
  Graph graph;
  graph.kernel = "k";
  graph.inputs = {{.label = "x", .extents = {}}};
  graph.input_values = {1};
  NodeId const x = table.intern(Node::input(0));
  for (double exponent : exponents)
    graph.results.push_back(table.intern(table.operation(Op::pow, x, table.constant(exponent))));
  graph.outputs = {
      {.label = "y", .extents = {exponents.size()}, .first = 0, .count = static_cast<std::uint32_t>(exponents.size())}};
  graph.nodes = table.release();
  return graph;
}

int cost(Graph const &graph) {
  std::vector<char> const live = live_nodes(graph);
  int sum = 0;
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (live[id] && !is_leaf(graph.nodes[id].op)) sum += info(graph.nodes[id].op).cost;
  return sum;
}

std::vector<std::string> const pass = {"powers"};

// x^n is off by n / 2 units in the last place at most, as the page on floating point says, and a unit for the root or
// the reciprocal.
TEST(Powers, AreAsExactAsTheirMultiplicationsRound) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(-4, 4);
  for (int halves = -128; halves <= 128; ++halves) {
    if (halves == 0) continue;
    Graph const made = run_passes(powers_of_one({halves / 2.0}), pass, FloatingPoint::fast);
    for (Node const &node : made.nodes) EXPECT_NE(node.op, Op::pow) << halves;
    double worst = 0;
    for (int sample = 0; sample < 200; ++sample) {
      double const x = std::exp2(exponent(random));
      long double const exact = powl(x, halves / 2.0L);
      double const value = evaluate(made, std::vector{x}, {})[made.results[0]];
      worst = std::max(worst, static_cast<double>(std::fabs(value - exact) / exact));
    }
    EXPECT_LE(worst, (std::abs(halves) / 4.0 + 1.5) * 0x1p-52) << halves / 2.0;
  }
}

TEST(Powers, AreNeverDearerAndShareWhatTheyCan) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    std::vector<double> exponents;
    for (std::size_t count = 1 + random() % 6; exponents.size() < count;)
      if (int const halves = static_cast<int>(random() % 61) - 30; halves != 0) exponents.push_back(halves / 2.0);
    Graph const graph = powers_of_one(exponents), made = run_passes(graph, pass, FloatingPoint::fast);
    EXPECT_LT(cost(made), cost(graph));
    int alone = 0;
    for (double each : std::set<double>(exponents.begin(), exponents.end()))
      alone += cost(run_passes(powers_of_one({each}), pass, FloatingPoint::fast));
    EXPECT_LE(cost(made), alone);
  }
}

// Where a call costs as much as an addition there is nothing to gain.
TEST(Powers, StayCallsWhereTheseAreCheaper) {
  CostModel costs = usual_costs();
  costs.work[static_cast<std::size_t>(Op::pow)] = 2;
  Graph const graph = powers_of_one({3});
  EXPECT_EQ(run_passes(graph, pass, {FloatingPoint::fast, 1, costs}).nodes.size(), graph.nodes.size());
  EXPECT_EQ(run_passes(powers_of_one({2}), pass, {FloatingPoint::fast, 1, costs}).nodes.back().op, Op::mul);
}

} // namespace
} // namespace symreal
