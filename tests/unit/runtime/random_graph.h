// Random straight-line programs with much to find in them: sums of products that share factors, mirrored products,
// sines and cosines of one angle, quotients, selects.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"

#include <random>

namespace symreal::test {

inline Graph random_graph(std::uint64_t seed, std::size_t operations) {
  std::mt19937_64 random(seed);
  Graph graph;
  constexpr std::uint32_t inputs = 6, parameters = 2;
  graph.kernel = "k";
  graph.inputs = {{.label = "x", .extents = {inputs}, .first = 0, .count = inputs}};
  graph.parameters = {{.label = "p", .extents = {parameters}, .first = 0, .count = parameters}};
  graph.input_values.assign(inputs, 0.5);
  graph.parameter_values.assign(parameters, 0.5);
  NodeTable table;
  std::vector<NodeId> nodes;
  auto operation = [&](Op op, NodeId a, NodeId b = no_node, NodeId c = no_node) {
    nodes.push_back(table.intern(table.operation(op, a, b, c)));
    return nodes.back();
  };
  for (std::uint32_t slot = 0; slot < inputs; ++slot) nodes.push_back(table.intern(Node::input(slot)));
  for (std::uint32_t slot = 0; slot < parameters; ++slot) nodes.push_back(table.intern(Node::parameter(slot)));
  for (double value : {2.0, 0.1, -0.75, 1.0}) nodes.push_back(table.constant(value));
  NodeId const one = nodes.back();
  auto any = [&] { return nodes[nodes.size() - 1 - random() % std::min<std::size_t>(nodes.size(), 24)]; };
  while (nodes.size() < operations) {
    NodeId const a = any(), b = any(), c = any();
    switch (random() % 12) {
    case 0: operation(Op::add, operation(Op::mul, a, b), operation(Op::mul, a, c)); break;
    case 1: operation(Op::sub, operation(Op::mul, b, a), operation(Op::mul, c, a)); break;
    case 2: operation(Op::mul, operation(Op::sin, a), b); break;
    case 3: operation(Op::mul, operation(Op::cos, a), c); break;
    case 4: operation(Op::div, a, operation(Op::add, operation(Op::mul, b, b), one)); break;
    case 5: operation(Op::select, operation(Op::lt, a, b), a, c); break;
    case 6: operation(Op::neg, a); break;
    case 7: operation(Op::atan, a); break;
    case 8: operation(Op::sub, operation(Op::add, a, b), b); break;
    case 9: operation(Op::mul, a, b); break;
    case 10: operation(Op::sub, a, b); break;
    default: operation(Op::add, a, operation(Op::tanh, b)); break;
    }
  }
  for (int k = 0; k < 5; ++k) graph.results.push_back(any());
  graph.outputs = {{.label = "y", .extents = {5}, .first = 0, .count = 5}};
  graph.nodes = table.release();
  return graph;
}

} // namespace symreal::test
