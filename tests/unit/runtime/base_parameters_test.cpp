// Which parameters can be left out, and what becomes of the others.
#include "engine/graph/evaluate.h"
#include "engine/graph/graph_text.h"
#include "engine/optimise/algebra/base_parameters.h"
#include "engine/optimise/algebra/graph_network.h"

#include "graph_words.h"

#include <gtest/gtest.h>

namespace symreal::algebra {
namespace {

using test::text;

Graph read(std::string const &body) { return read_graph("symreal-graph 1\nkernel \"k\"\n" + body, "test"); }

std::optional<Graph> with_base(Graph const &graph) {
  std::optional<Network> const made = with_base_parameters(rebuilt(network_of(graph)));
  return made ? graph_of(rebuilt(*made), graph) : std::nullopt;
}

void expect_same(Graph const &graph, Graph const &made) {
  std::vector<double> x = {0.3, -1.7, 2.5}, p = {1.5, 0.25, -3, 0.7};
  x.resize(graph.input_count()), p.resize(graph.parameter_count());
  std::vector<double> const before = evaluate_sample(graph, x, p).outputs, after = evaluate_sample(made, x, p).outputs;
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(before[i], after[i], 1e-15);
}

// x p0 + y p1 + (0.45 x + y) p2, and p2 is left out.
TEST(BaseParameters, OneThatIsASumOfOthersIsLeftOut) {
  Graph const graph = read("input \"x\" [2]\nparameter \"p\" [3]\noutput \"y\"\n%0 = input 0\n%1 = input 1\n"
                           "%2 = parameter 0\n%3 = parameter 1\n%4 = parameter 2\n%5 = mul %0 %2\n%6 = mul %1 %3\n"
                           "%7 = mul %0 0.45\n%8 = add %7 %1\n%9 = mul %8 %4\n%10 = add %5 %6\n%11 = add %10 %9\n"
                           "result 0 %11\n");
  std::optional<Graph> const made = with_base(graph);
  ASSERT_TRUE(made);
  expect_same(graph, *made);
  std::size_t products = 0;
  for (Node const &node : made->nodes) products += node.op == Op::mul && node.attribute == Attribute::variable;
  EXPECT_EQ(products, 2u) << text(*made);
  EXPECT_NE(text(*made).find("0.45"), std::string::npos) << "to the last bit: " << text(*made);
}

// With squares of sine and cosine: (c^2 + s^2) p0 + p1.
TEST(BaseParameters, WhatAnAngleDoesNotChangeIsSeen) {
  Graph const graph = read("input \"x\"\nparameter \"p\" [2]\noutput \"y\"\n%0 = input 0\n%1 = sin %0\n%2 = cos %0\n"
                           "%3 = parameter 0\n%4 = parameter 1\n%5 = mul %1 %3\n%6 = mul %5 %1\n%7 = mul %2 %3\n"
                           "%8 = mul %7 %2\n%9 = mul %0 %4\n%10 = add %6 %8\n%11 = mul %10 %0\n%12 = add %11 %9\n"
                           "result 0 %12\n");
  std::optional<Graph> const made = with_base(graph);
  ASSERT_TRUE(made);
  expect_same(graph, *made);
}

// Both are used as a whole by something that is not linear.
TEST(BaseParameters, WhatIsNotLinearKeepsItsParameters) {
  EXPECT_FALSE(with_base(read("input \"x\"\nparameter \"p\" [2]\noutput \"y\"\n%0 = input 0\n%1 = parameter 0\n"
                              "%2 = parameter 1\n%3 = mul %0 %1\n%4 = mul %0 %2\n%5 = sqrt %3\n%6 = exp %4\n"
                              "%7 = add %5 %6\nresult 0 %7\n")));
}

// Their sum alone is: sqrt(x p0 + x p1).
TEST(BaseParameters, WhatIsNotLinearMayUseASum) {
  Graph const graph = read("input \"x\"\nparameter \"p\" [2]\noutput \"y\"\n%0 = input 0\n%1 = parameter 0\n"
                           "%2 = parameter 1\n%3 = mul %0 %1\n%4 = mul %0 %2\n%5 = add %3 %4\n%6 = sqrt %5\n"
                           "result 0 %6\n");
  std::optional<Graph> const made = with_base(graph);
  ASSERT_TRUE(made);
  expect_same(graph, *made);
}

// A quotient of parameters may be infinite, and comes to stand nowhere else.
TEST(BaseParameters, QuotientsStayWhereTheyAre) {
  EXPECT_FALSE(with_base(read("input \"x\"\nparameter \"p\" [3]\noutput \"y\"\n%0 = input 0\n%1 = parameter 0\n"
                              "%2 = parameter 1\n%3 = parameter 2\n%4 = div %1 %2\n%5 = mul %0 %4\n%6 = mul %0 %3\n"
                              "%7 = add %5 %6\nresult 0 %7\n")));
}

} // namespace
} // namespace symreal::algebra
