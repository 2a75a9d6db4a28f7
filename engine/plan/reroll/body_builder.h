// Builder of the body of a step: a graph whose inputs are its leaves.
#pragma once

#include "engine/graph/node_table.h"
#include "engine/plan/reroll/loop_program.h"

namespace symreal::reroll {

class BodyBuilder {
public:
  explicit BodyBuilder(Graph const &graph) : graph_(&graph) {}

  NodeId leaf(Leaf leaf) {
    leaves_.push_back(std::move(leaf));
    return nodes_.intern(Node::input(static_cast<std::uint32_t>(leaves_.size() - 1)));
  }
  NodeId constant(double value) { return nodes_.constant(value); }
  // `like`: node of the graph that gives the operation its name and source location.
  NodeId operation(Op op, std::array<NodeId, 3> const &operands, NodeId like);
  void store(NodeId value, bool is_result, Access access) { stores_.push_back({value, is_result, std::move(access)}); }
  void carry(NodeId leaf, NodeId next) { leaves_[nodes_[leaf].slot()].next = next; }
  bool is_empty() const { return stores_.empty(); }

  // `nest`: loop nest of the iterations, if known.
  Step finish(std::uint32_t count, std::optional<Nest> const &nest = {});

private:
  Graph const *graph_;
  NodeTable nodes_;
  std::vector<NodeId> like_; // per node, or no_node
  std::vector<Leaf> leaves_;
  std::vector<Store> stores_;
};

} // namespace symreal::reroll
