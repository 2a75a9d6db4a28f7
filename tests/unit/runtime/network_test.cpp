// Nodes that are equal by algebra are one, and none is that rests on what the other does not.
#include "engine/graph/graph_text.h"
#include "engine/optimise/algebra/graph_network.h"

#include "graph_words.h"

#include <gtest/gtest.h>

namespace symreal::algebra {
namespace {

using test::text;

struct Fixture : ::testing::Test {
  Network network{std::make_shared<Context>()};
  Literal x = input(0), y = input(1), z = input(2);

  Literal input(std::uint32_t slot) { return network.leaf(slot, Attribute::variable, no_hazard, random_value(slot)); }
  Literal parameter(std::uint32_t slot) {
    return network.leaf(100 + slot, Attribute::parametric, no_hazard, random_parameter(slot));
  }
  Literal call(Op op, Literal a) { return network.function({op, 1, {a}}); }
};
using NetworkTest = Fixture;

TEST_F(NetworkTest, EqualByAlgebraIsOne) {
  EXPECT_EQ(network.product(x, y), network.product(y, x));
  EXPECT_EQ(network.sum(network.sum(x, y), z), network.sum(x, network.sum(y, z)));
  EXPECT_EQ(network.product(x, network.sum(y, z)), network.sum(network.product(x, y), network.product(x, z)));
  EXPECT_EQ(network.sum(x, -y), -network.sum(y, -x));
  EXPECT_EQ(network.sum(network.sum(x, y), -y), x);
  EXPECT_EQ(network.sum(x, x), network.product(network.constant(2.0), x));
}

TEST_F(NetworkTest, NumbersAreSeen) {
  Literal const s = call(Op::sin, x), c = call(Op::cos, x);
  Literal const one = network.sum(network.product(s, s), network.product(c, c));
  EXPECT_EQ(one, network.one());
  Literal const half = network.constant(0.5);
  EXPECT_EQ(network.sum(network.product(half, network.product(s, s)), network.product(network.product(half, c), c)),
            half);
  EXPECT_EQ(network.sum(network.product(s, c), -network.product(c, s)), network.zero());
}

TEST_F(NetworkTest, FunctionsAreOddOrEven) {
  EXPECT_EQ(call(Op::sin, -x), -call(Op::sin, x));
  EXPECT_EQ(call(Op::cos, -x), call(Op::cos, x));
  EXPECT_EQ(call(Op::exp, network.sum(x, y)), call(Op::exp, network.sum(y, x)));
  EXPECT_NE(call(Op::exp, -x).node(), call(Op::exp, x).node());
}

TEST_F(NetworkTest, WhatIsConstantIsNotFoldedEarly) {
  Literal const product = network.product(network.constant(0.1), network.constant(0.3));
  EXPECT_EQ(network[product].kind, Kind::product);
  EXPECT_EQ(network[product].attribute, Attribute::constant);
  EXPECT_EQ(network[network.quotient(x, parameter(0))].kind, Kind::product) << "by a reciprocal that costs nothing";
}

// y = (y / x) * x, but where x is 0.
TEST_F(NetworkTest, NothingComesToRestOnADivision) {
  Literal const there = network.product(network.quotient(z, x), y);
  Literal const bare = network.sum(z, y);
  Literal const guarded = network.sum(network.product(network.quotient(z, x), x), y);
  EXPECT_EQ(guarded, bare) << "this way round it may be";
  EXPECT_FALSE(network.hazards().is_subset(network[there].hazards, network[bare].hazards));
}

TEST_F(NetworkTest, WhatRestsOnLessIsFoundLater) {
  Network other(std::make_shared<Context>());
  Literal const a = other.leaf(0, Attribute::variable, no_hazard, random_value(0));
  Literal const b = other.leaf(1, Attribute::variable, no_hazard, random_value(1));
  Literal const root = other.function({Op::sqrt, 1, {a}});
  // a + b, once by way of the root, which the second must not rest on.
  Literal const first = other.sum(other.sum(a, root), other.sum(b, -root));
  Literal const second = other.sum(a, b);
  EXPECT_TRUE(other.hazards().is_subset(other[second].hazards, no_hazard));
  (void)first;
}

// x + y - y with y in it would be lost in rounding where y is large.
TEST_F(NetworkTest, NothingComesToRestOnAnotherInput) {
  Network other(std::make_shared<Context>());
  auto leaf = [&](std::uint32_t slot) {
    return other.leaf(slot, Attribute::variable, other.hazards().of_input(slot), random_value(slot));
  };
  Literal const a = leaf(0), b = leaf(1);
  Literal const square = other.product(a, a);
  Literal const long_way = other.sum(other.product(other.sum(a, b), other.sum(a, -b)), other.product(b, b));
  EXPECT_EQ(long_way, square) << "this way round it may be";
  EXPECT_FALSE(other.hazards().is_subset(other[b].hazards, other[square].hazards));
  EXPECT_EQ(other.hazards().inputs_in(other[other.quotient(a, b)].hazards), other[other.sum(a, b)].hazards);
}

TEST_F(NetworkTest, CommonDenominatorsDivideOnce) {
  network.roots = {network.quotient(x, z), network.quotient(y, z)};
  EXPECT_EQ(cost_of(network), 8u);
  EXPECT_EQ(cost_of(with_common_reciprocals(network)), 6u);
}

Graph read(std::string const &body) { return read_graph("symreal-graph 1\n" + body, "test"); }

TEST(GraphNetwork, ExactOperationsStayAsTheyAreWritten) {
  // The correction of a compensated sum.
  Graph graph = read("kernel \"k\"\ninput \"x\" [2]\noutput \"y\"\n%0 = input 0\n%1 = input 1\n%2 = add %0 %1\n"
                     "%3 = sub %2 %0\n%4 = sub %1 %3\nresult 0 %4\n");
  Network const network = rebuilt(network_of(graph));
  EXPECT_EQ(network.roots[0], network.zero());
  graph.node_exact.assign(graph.nodes.size(), 1);
  std::optional<Graph> const same = graph_of(rebuilt(network_of(graph)), graph);
  ASSERT_TRUE(same);
  EXPECT_EQ(text(*same), text(graph));
}

TEST(GraphNetwork, OperandsOfOtherOperationsKeepTheirSigns) {
  Graph const graph = read("kernel \"k\"\ninput \"x\" [1]\noutput \"y\" [2]\n%0 = input 0\n%1 = copysign %0 -0\n"
                           "%2 = add %0 -0\nresult 0 %1\nresult 1 %2\n");
  std::optional<Graph> const made = graph_of(network_of(graph), graph);
  ASSERT_TRUE(made);
  EXPECT_NE(text(*made).find("copysign %0 -0"), std::string::npos);
  EXPECT_NE(text(*made).find("result 1 %0"), std::string::npos);
}

TEST(GraphNetwork, NumbersBeyondDoublesAreRefused) {
  Graph const graph = read("kernel \"k\"\ninput \"x\" [1]\noutput \"y\"\n%0 = input 0\n%1 = mul %0 1e200\n"
                           "%2 = mul 1e200 1e200\n%3 = mul %0 %2\nresult 0 %3\n");
  EXPECT_FALSE(graph_of(rebuilt(network_of(graph)), graph));
}

} // namespace
} // namespace symreal::algebra
