#include "engine/graph/evaluate.h"
#include "engine/graph/graph_text.h"
#include "engine/graph/value_range.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace symreal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Operations at random on three inputs, with the constants that make bounds.
Graph random_graph(std::mt19937_64 &random) {
  Graph graph = read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\" [3]\noutput \"y\"\n%0 = input 0\n%1 = input 1\n"
                           "%2 = input 2\nresult 0 %2\n",
                           "test");
  for (double constant : {0.0, 1.0, -2.5, 3.0}) graph.nodes.push_back(Node::constant(constant));
  for (int k = 0; k < 60; ++k) {
    auto const node = [&] {
      auto id = static_cast<NodeId>(random() % graph.nodes.size());
      while (is_wide(graph.nodes[id].op)) --id; // the first are inputs
      return id;
    };
    OperationInfo const &operation = operations()[random() % operations().size()];
    if (operation.has(flag::OPAQUE) || operation.has(flag::LOGICAL)) continue;
    std::array<NodeId, 3> operands = {no_node, no_node, no_node};
    for (unsigned i = 0; i < operation.arity; ++i) {
      operands[i] = node();
      if (!takes_wide(operation.op, i)) continue;
      graph.nodes.push_back({Op::wide_int, Attribute::variable, {operands[i], no_node, no_node}});
      operands[i] = static_cast<NodeId>(graph.nodes.size() - 1);
    }
    if (operation.op == Op::select) { // of something that may be compared with what it chooses
      graph.nodes.push_back({random() % 2 ? Op::lt : Op::ge, Attribute::variable, {operands[1], node(), no_node}});
      operands[0] = static_cast<NodeId>(graph.nodes.size() - 1);
      if (random() % 2) operands[2] = graph.nodes.back().operand[1];
    }
    graph.nodes.push_back({operation.op, Attribute::variable, operands});
  }
  return graph;
}

void expect_within(Graph const &graph, ValueRanges const &ranges, std::array<double, 3> const &inputs,
                   bool any_finite) {
  std::vector<double> const values = evaluate(graph, inputs, {});
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (any_finite && !std::isfinite(values[k])) break; // from here on it is outside of the premise
    Node const &node = graph.nodes[k];
    if (node.op == Op::int32 && !(std::fabs(values[node.operand[0]]) < 0x1p31)) break; // or undefined
    if (node.op == Op::int64 && !(std::fabs(values[node.operand[0]]) < 0x1p63)) break;
    Interval const range = ranges.range(static_cast<NodeId>(k));
    EXPECT_TRUE(std::isnan(values[k]) ? range.nan : range.low <= values[k] && values[k] <= range.high)
        << "node " << k << " " << (is_leaf(node.op) ? "leaf" : info(node.op).name) << " is " << values[k]
        << ", not in [" << range.low << ", " << range.high << "]";
  }
}

TEST(ValueRange, HoldsTheValuesOfEveryMode) {
  std::mt19937_64 random(20131);
  std::normal_distribution<double> normal(0, 3);
  constexpr std::array corners = {0.0, -0.0, 1.0, -2.5, infinity, -infinity, not_a_number, 1e308, -1e308, 5e-324};
  for (int g = 0; g < 200; ++g) {
    Graph const graph = random_graph(random);
    for (FloatingPoint mode : {FloatingPoint::finite, FloatingPoint::strict}) {
      ValueRanges const ranges(graph, mode);
      for (int k = 0; k < 50; ++k) {
        std::array<double, 3> inputs{};
        for (double &x : inputs) x = random() % 4 ? normal(random) : corners[random() % corners.size()];
        expect_within(graph, ranges, inputs, mode == FloatingPoint::finite);
      }
    }
  }
}

TEST(ValueRange, BoundsAClampedIndex) {
  Graph const graph = read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\"\noutput \"y\"\n%0 = input 0\n"
                                 "%1 = int32 %0\n%2 = lt %1 0\n%3 = select %2 0 %1\n%4 = lt 5 %3\n"
                                 "%5 = select %4 5 %3\n%6 = add %5 1\nresult 0 %6\n",
                                 "test");
  auto const last = static_cast<NodeId>(graph.nodes.size() - 1);
  Interval const range = ValueRanges(graph, FloatingPoint::finite).range(last);
  EXPECT_EQ(range.low, 1);
  EXPECT_EQ(range.high, 6);
  EXPECT_FALSE(range.nan);
  EXPECT_TRUE(ValueRanges(graph, FloatingPoint::strict).range(last).nan);
}

} // namespace
} // namespace symreal
