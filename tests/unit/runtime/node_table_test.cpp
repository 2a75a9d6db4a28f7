#include "engine/graph/node_table.h"

#include <gtest/gtest.h>
#include <set>

namespace symreal {
namespace {

TEST(NodeTable, NoComputationExistsTwice) {
  NodeTable table;
  NodeId const x = table.intern(Node::input(0)), y = table.intern(Node::input(1));
  NodeId const sum = table.intern(table.operation(Op::add, x, y));
  EXPECT_EQ(table.intern(table.operation(Op::add, x, y)), sum);
  EXPECT_NE(table.intern(table.operation(Op::add, y, x)), sum);
  EXPECT_NE(table.intern(table.operation(Op::sub, x, y)), sum);
  EXPECT_EQ(table.constant(2.5), table.constant(2.5));
  EXPECT_NE(table.constant(0.0), table.constant(-0.0));
}

// A node with many users leaves the list for the hash table; every one of them must still be found.
TEST(NodeTable, UsersOfAHubAreFound) {
  NodeTable table;
  NodeId const hub = table.intern(Node::input(0));
  std::vector<NodeId> constants, users;
  for (int k = 0; k < 1000; ++k) constants.push_back(table.constant(k));
  NodeId const newest = table.intern(Node::input(1));
  for (NodeId constant : constants) users.push_back(table.intern(table.operation(Op::mul, newest, constant)));
  EXPECT_EQ(std::set<NodeId>(users.begin(), users.end()).size(), users.size());
  for (std::size_t k = 0; k < users.size(); ++k)
    EXPECT_EQ(table.intern(table.operation(Op::mul, newest, constants[k])), users[k]);
  EXPECT_EQ(table.size(), 2 + constants.size() + users.size());
  EXPECT_EQ(hub, 0u);
}

TEST(NodeTable, AttributesFollowFromOperands) {
  NodeTable table;
  NodeId const constant = table.constant(1), parameter = table.intern(Node::parameter(0)),
               input = table.intern(Node::input(0));
  EXPECT_EQ(table.operation(Op::add, constant, constant).attribute, Attribute::constant);
  EXPECT_EQ(table.operation(Op::add, constant, parameter).attribute, Attribute::parametric);
  EXPECT_EQ(table.operation(Op::add, parameter, input).attribute, Attribute::variable);
  EXPECT_EQ(table.operation(Op::select, input, constant, constant).attribute, Attribute::variable);
}

} // namespace
} // namespace symreal
