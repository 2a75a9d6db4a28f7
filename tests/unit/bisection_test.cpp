// Which pass, and which rewrite, is the first that is wrong.
#include "verify/bisection.h"

#include "engine/graph/graph_text.h"
#include "engine/optimise/passes/rule.h"

#include <gtest/gtest.h>

namespace symreal::program {
namespace {

Graph graph_of(std::string const &nodes) {
  return read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\" [2] = 1 2\noutput \"y\"\n" + nodes, "test");
}

Graph with_two_for_one(Graph graph, PassSettings const &) {
  for (Node &node : graph.nodes)
    if (node.is_constant() && node.value() == 1) node = Node::constant(2);
  return graph;
}

Graph as_it_is(Graph const &graph, PassSettings const &) { return graph; }

// Rules of mode fast, which finite does not have.
Graph with_fast_rules(Graph const &graph, PassSettings const &settings) {
  return sweep(graph, {.mode = FloatingPoint::fast,
                       .topics = static_cast<unsigned>(Topic::identities) | static_cast<unsigned>(Topic::algebra),
                       .limit = settings.limit});
}

TEST(Bisection, NamesThePass) {
  Graph const graph = graph_of("%0 = input 0\n%1 = mul %0 3\n%2 = add %1 1\nresult 0 %2\n");
  std::vector<NamedPass> const passes = {{"first", as_it_is}, {"second", with_two_for_one}, {"third", as_it_is}};
  auto const culprit = find_culprit(graph, passes, FloatingPoint::finite, 0, {{5, 0}, {}});
  ASSERT_TRUE(culprit);
  EXPECT_EQ(culprit->pass, "second");
  EXPECT_EQ(culprit->before, 16);
  EXPECT_EQ(culprit->after, 17);
  EXPECT_EQ(culprit->rewrites, 0u); // it does not rewrite node by node
}

TEST(Bisection, NamesTheRewrite) {
  // Two rewrites are right before the one that is not.
  Graph const graph = graph_of("%0 = input 0\n%1 = input 1\n%2 = mul %0 1\n%3 = add %1 0\n%4 = add %2 %3\n"
                               "%5 = sub %4 %3\nresult 0 %5\n");
  auto const culprit = find_culprit(graph, {{"wrong", with_fast_rules}}, FloatingPoint::finite, 0, {{1e-17, 1}, {}});
  ASSERT_TRUE(culprit);
  EXPECT_EQ(culprit->pass, "wrong");
  EXPECT_EQ(culprit->rewrites, 3u);
  EXPECT_EQ(culprit->rule, "(sub (add x y) y) -> x");
}

TEST(Bisection, FindsNothingWhereNothingIsWrong) {
  Graph const graph = graph_of("%0 = input 0\n%1 = mul %0 1\n%2 = add %1 %1\nresult 0 %2\n");
  EXPECT_FALSE(find_culprit(graph, default_pipeline(FloatingPoint::finite), FloatingPoint::finite, 0, {{5, 0}, {}}));
}

} // namespace
} // namespace symreal::program
