// Sines and cosines of sums of angles: the field knows them, deriving them keeps the error bound, and never costs more.
#include "engine/graph/evaluate.h"
#include "engine/graph/extended.h"
#include "engine/graph/node_table.h"
#include "engine/graph/statistics.h"
#include "engine/graph/validate.h"
#include "engine/optimise/algebra/angle_sums.h"
#include "engine/optimise/algebra/recovery.h"
#include "engine/optimise/passes/pass.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace symreal::algebra {
namespace {

struct AnglesTest : ::testing::Test {
  Network network{std::make_shared<Context>()};
  Literal x = input(0), y = input(1);

  Literal input(std::uint32_t slot) { return network.leaf(slot, Attribute::variable, no_hazard, random_value(slot)); }
  Literal call(Op op, Literal a) { return network.function({op, 1, {a}}); }
  Literal quarters(int count, Literal a) { return network.product(network.constant(count / 4.0), a); }
};

TEST_F(AnglesTest, FormsAreSumsOfQuarters) {
  Literal const angle = network.sum(network.sum(network.product(network.constant(2.0), x), -y), quarters(2, x));
  EXPECT_EQ(form_of(network, angle.node()),
            (AngleForm{{x.node(), angle.is_negative() ? -10 : 10}, {y.node(), angle.is_negative() ? 4 : -4}}));
  Literal const third = network.product(network.constant(0.3), x);
  EXPECT_EQ(form_of(network, third.node()), (AngleForm{{third.node(), 4}})) << "no multiple";
  Literal const large = network.product(network.constant(1000.0), x);
  EXPECT_EQ(form_of(network, large.node()), (AngleForm{{large.node(), 4}}));
}

TEST_F(AnglesTest, TheFieldKnowsSumsAndMultiples) {
  Angles &angles = network.context()->angles;
  Value const a = network[x].value, b = network[y].value, sum = a + b, half = a * value_of(0.5);
  AnglePart const parts[] = {{a, 4}, {b, 4}}, one[] = {{a, 4}}, other[] = {{b, 4}}, halves[] = {{a, 2}};
  angles.add(sum, parts), angles.add(a, one), angles.add(b, other), angles.add(half, halves);
  Value const s = angles.sine(a) * angles.cosine(b) + angles.cosine(a) * angles.sine(b);
  EXPECT_TRUE(equal_in_field(s, angles.sine(sum)));
  EXPECT_TRUE(confirmed(s, angles.sine(sum), 1));
  EXPECT_TRUE(equal_in_field(-s, angles.sine(-sum)));
  Value const twice = angles.sine(half) * angles.cosine(half) * value_of(2);
  EXPECT_TRUE(equal_in_field(twice, angles.sine(a)));
  EXPECT_FALSE(equal_in_field(angles.sine(a + -b), angles.sine(sum)));
}

// Sines and cosines of random combinations of four inputs and a parameter, and sums of their products.
Graph random_angles(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  NodeTable table;
  Graph graph;
  graph.kernel = "k";
  graph.inputs = {{.label = "x", .extents = {4}, .first = 0, .count = 4}};
  graph.parameters = {{.label = "p", .extents = {}}};
  graph.input_values.assign(4, 0.5);
  graph.parameter_values = {0.5};
  std::vector<NodeId> angles, parts;
  auto operation = [&](Op op, NodeId a, NodeId b = no_node) { return table.intern(table.operation(op, a, b)); };
  for (std::uint32_t slot = 0; slot < 4; ++slot) angles.push_back(table.intern(Node::input(slot)));
  angles.push_back(table.intern(Node::parameter(0)));
  NodeId const two = table.constant(2);
  for (int k = 0; k < 6; ++k) {
    NodeId const a = angles[random() % angles.size()], b = angles[random() % angles.size()];
    angles.push_back(random() % 5 == 0 ? operation(Op::mul, two, a)
                                       : operation(random() % 3 ? Op::add : Op::sub, a, b));
  }
  for (int k = 0; k < 12; ++k)
    parts.push_back(operation(random() % 2 ? Op::sin : Op::cos, angles[random() % angles.size()]));
  for (int k = 0; k < 6; ++k) {
    auto any = [&] { return parts[random() % parts.size()]; };
    parts.push_back(operation(random() % 2 ? Op::add : Op::sub, operation(Op::mul, any(), any()),
                              operation(Op::mul, any(), any())));
  }
  for (int k = 0; k < 6; ++k) graph.results.push_back(parts[parts.size() - 1 - k]);
  graph.outputs = {{.label = "y", .extents = {6}, .first = 0, .count = 6}};
  graph.nodes = table.release();
  return graph;
}

int cost(Graph const &graph) {
  std::vector<char> const live = symreal::live_nodes(graph);
  int sum = 0;
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (Node const &node = graph.nodes[id]; live[id] && !is_leaf(node.op) && node.attribute == Attribute::variable)
      sum += info(node.op).cost;
  return sum;
}

TEST(AngleSums, RandomGraphsStayWhatTheyAre) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-2, 2);
  int before = 0, after = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Graph const graph = random_angles(seed), made = recover_structure(graph, 1);
    ASSERT_EQ(find_violation(made), "") << seed;
    EXPECT_LE(cost(made), cost(graph)) << seed;
    before += cost(graph), after += cost(made);
    std::vector<double> x(4), p = {uniform(random)};
    for (double &each : x) each = uniform(random);
    std::vector<double> const values = evaluate(graph, x, p), now = evaluate(made, x, p);
    std::vector<long double> const exact = evaluate_extended(graph, x, p, values).value();
    for (std::size_t k = 0; k < exact.size(); ++k)
      EXPECT_NEAR(now[made.results[k]], static_cast<double>(exact[k]), 400 * 0x1p-53) << seed << ' ' << k;
  }
  EXPECT_LT(after, before * 9 / 10) << "there is much to find";
}

// sin(k x) and cos(k x), as in a series.
TEST(AngleSums, MultiplesKeepTheirBound) {
  NodeTable table;
  Graph graph;
  graph.kernel = "k";
  graph.inputs = {{.label = "x", .extents = {}}};
  graph.input_values = {0.5};
  NodeId const x = table.intern(Node::input(0));
  for (double k = 1; k <= 12; ++k)
    for (Op op : {Op::sin, Op::cos}) {
      NodeId const angle = k == 1 ? x : table.intern(table.operation(Op::mul, x, table.constant(k)));
      graph.results.push_back(table.intern(table.operation(op, angle)));
    }
  graph.outputs = {{.label = "y", .extents = {24}, .first = 0, .count = 24}};
  graph.nodes = table.release();
  Graph const made = recover_structure(graph, 1);
  OperationCounts const counts = statistics(made).compute;
  EXPECT_GE(counts[Op::sin] + counts[Op::cos], 4u) << "of eight angles at most";
  EXPECT_LE(counts[Op::sin] + counts[Op::cos], 10u);
  double worst = 0;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (int sample = 0; sample < 1000; ++sample) {
    std::vector<double> const at = {uniform(random)}, now = evaluate(made, at, {});
    for (std::size_t k = 0; k < 24; ++k) {
      long double const angle = (static_cast<long double>(k / 2) + 1) * at[0];
      worst =
          std::max(worst, static_cast<double>(std::fabs(now[made.results[k]] - (k % 2 ? cosl(angle) : sinl(angle)))));
    }
  }
  EXPECT_LE(worst, 24 * 0x1p-52);
  RecordProperty("worst", std::to_string(worst));
  std::cout << "worst error " << worst << ", calls " << counts[Op::sin] + counts[Op::cos] << '\n';
}

// Where calls are cheap, they stay.
TEST(AngleSums, TheCostsDecide) {
  CostModel cheap = usual_costs();
  cheap.work[static_cast<std::size_t>(Op::sin)] = cheap.work[static_cast<std::size_t>(Op::cos)] = 1;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Graph const graph = random_angles(seed), made = recover_structure(graph, 1, cheap);
    OperationCounts const before = statistics(graph).compute, after = statistics(made).compute;
    EXPECT_LE(after.arithmetic() + after[Op::sin] + after[Op::cos],
              before.arithmetic() + before[Op::sin] + before[Op::cos]);
  }
}

// Without the marks of what is exact all three calls become one of a sum.
TEST(AngleSums, WhatIsExactStays) {
  NodeTable table;
  Graph graph;
  graph.kernel = "k";
  graph.inputs = {{.label = "x", .extents = {2}, .first = 0, .count = 2}};
  graph.input_values = {0.5, 0.5};
  NodeId const x = table.intern(Node::input(0)), y = table.intern(Node::input(1));
  NodeId const sum = table.intern(table.operation(Op::add, x, y));
  for (NodeId angle : {x, y, sum})
    for (Op op : {Op::sin, Op::cos}) graph.results.push_back(table.intern(table.operation(op, angle)));
  graph.outputs = {{.label = "y", .extents = {6}, .first = 0, .count = 6}};
  graph.nodes = table.release();
  std::vector<std::string> const passes = {"recover", "cull"};
  EXPECT_EQ(statistics(run_passes(graph, passes, {FloatingPoint::fast, 1})).compute[Op::sin], 2u);
  graph.node_exact.assign(graph.nodes.size(), 0);
  for (NodeId id = sum; id < graph.nodes.size(); ++id) graph.node_exact[id] = 1;
  EXPECT_EQ(statistics(run_passes(graph, passes, {FloatingPoint::fast, 1})).compute[Op::sin], 3u);
}

} // namespace
} // namespace symreal::algebra
