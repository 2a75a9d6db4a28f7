#include "program/record/path_tree.h"

#include <gtest/gtest.h>

using namespace symreal;
using program::Outcomes;
using program::PathTree;

namespace {

// A kernel of two inputs and one output. Decides on x > 0, and where that holds on y > 0.
struct Kernel {
  NodeTable table;
  NodeId x = table.intern(Node::input(0)), y = table.intern(Node::input(1)), zero = table.constant(0);

  NodeId positive(NodeId number) { return table.intern(table.operation(Op::gt, number, zero)); }

  program::RecordedPath path(std::vector<program::DecidedStep> steps, NodeId result) {
    program::RecordedPath path;
    path.graph.kernel = "f";
    path.graph.inputs = {{"x", {}, 0}, {"y", {}, 1}};
    path.graph.outputs = {{"z", {}}};
    path.graph.results = {result};
    path.graph.nodes = table.release();
    path.steps = std::move(steps);
    return path;
  }
};

program::RecordedPath path(Outcomes const &outcomes, bool on_other_value = false) {
  Kernel kernel;
  NodeId const first = kernel.positive(on_other_value ? kernel.y : kernel.x);
  std::vector<program::DecidedStep> steps = {{first, outcomes[0] == 't', false, outcomes[0] == 'j', "x > 0"}};
  if (outcomes.size() == 1) return kernel.path(steps, kernel.x);
  steps.push_back({kernel.positive(kernel.y), outcomes[1] == 't', false, outcomes[1] == 'j', "y > 0"});
  return kernel.path(steps, outcomes[1] == 't' ? kernel.y : kernel.x);
}

} // namespace

TEST(PathTree, ASelectStandsWherePathsDiffer) {
  PathTree tree;
  ASSERT_TRUE(tree.add(path("tt")));
  EXPECT_EQ(tree.next(), Outcomes("tf"));
  ASSERT_TRUE(tree.add(path("tf")));
  EXPECT_EQ(tree.next(), Outcomes("f"));
  ASSERT_TRUE(tree.add(path("f")));
  EXPECT_EQ(tree.next(), std::nullopt);
  Graph const graph = tree.merge();
  EXPECT_EQ(tree.selects(), 2u);
  EXPECT_TRUE(graph.guards.empty());
  Node const &outer = graph.nodes[graph.results.front()];
  ASSERT_EQ(outer.op, Op::select);
  EXPECT_EQ(graph.nodes[outer.operand[1]].op, Op::select);
  EXPECT_EQ(graph.nodes[outer.operand[2]], Node::input(0));
}

TEST(PathTree, EqualResultsNeedNoSelect) {
  PathTree tree;
  ASSERT_TRUE(tree.add(path("tf")));
  ASSERT_TRUE(tree.add(path("f")));
  program::RecordedPath other = path("tt");
  other.graph.results = {0};
  ASSERT_TRUE(tree.add(std::move(other)));
  Graph const graph = tree.merge();
  EXPECT_EQ(tree.selects(), 0u);
  EXPECT_EQ(graph.nodes[graph.results.front()], Node::input(0));
}

TEST(PathTree, AGuardStandsWhereAPathIsMissing) {
  PathTree tree;
  ASSERT_TRUE(tree.add(path("tf")));
  ASSERT_TRUE(tree.add(path("f")));
  Graph const graph = tree.merge();
  ASSERT_EQ(graph.guards.size(), 1u);
  EXPECT_EQ(graph.guards.front().text, "y > 0 is false where x > 0");
  EXPECT_EQ(tree.open_branches(), 1u);
}

TEST(PathTree, WhatNoSampleTakesIsNotAskedFor) {
  PathTree tree;
  program::RecordedPath only = path("tf");
  only.steps[0].is_met[false] = false;
  ASSERT_TRUE(tree.add(std::move(only)));
  EXPECT_EQ(tree.next(), Outcomes("tt"));
  ASSERT_TRUE(tree.add(path("tt")));
  EXPECT_EQ(tree.next(), Outcomes("f")); // a sample of the other path takes it
  PathTree another;
  for (Outcomes const outcomes : {"tf", "tt"}) {
    program::RecordedPath one = path(outcomes);
    one.steps[0].is_met[false] = false;
    ASSERT_TRUE(another.add(std::move(one)));
  }
  EXPECT_EQ(another.next(), std::nullopt);
  Graph const graph = another.merge();
  EXPECT_EQ(another.unmet(), 1u);
  EXPECT_EQ(another.open_branches(), 0u);
  ASSERT_EQ(graph.guards.size(), 1u);
  EXPECT_EQ(graph.guards.front().text, "x > 0");
}

TEST(PathTree, AProgramThatDoesNotRepeatItselfIsFound) {
  PathTree tree;
  ASSERT_TRUE(tree.add(path("tt")));
  EXPECT_FALSE(tree.add(path("tf", true)));
  EXPECT_FALSE(tree.add(path("t"))); // ends where another decides
}
