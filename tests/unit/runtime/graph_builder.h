// A graph of one array of inputs and one of outputs, operation by operation: make(Op::add, make.input(0), ...).
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"

#include <algorithm>
#include <vector>

namespace symreal::test {

class GraphBuilder {
public:
  NodeId input(std::uint32_t slot) {
    inputs_ = std::max(inputs_, slot + 1);
    return nodes_.intern(Node::input(slot));
  }
  NodeId number(double value) { return nodes_.constant(value); }
  NodeId operator()(Op op, NodeId a, NodeId b = no_node, NodeId c = no_node) {
    return nodes_.intern(nodes_.operation(op, a, b, c));
  }
  Graph finish(std::vector<NodeId> const &results, std::vector<NodeId> const &guards = {}) {
    Graph graph;
    graph.kernel = "k";
    auto const count = static_cast<std::uint32_t>(results.size());
    graph.inputs = {{"x", {inputs_}, 0, inputs_}};
    graph.input_values.assign(inputs_, 0);
    graph.outputs = {{"y", {count}, 0, count}};
    graph.nodes = nodes_.release();
    graph.results = results;
    for (NodeId guard : guards) graph.guards.push_back({guard, no_location, "0 < x"});
    return graph;
  }

private:
  NodeTable nodes_;
  std::uint32_t inputs_ = 0;
};

} // namespace symreal::test
