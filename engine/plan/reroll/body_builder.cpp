#include "engine/plan/reroll/body_builder.h"

namespace symreal::reroll {

NodeId BodyBuilder::operation(Op op, std::array<NodeId, 3> const &operands, NodeId like) {
  NodeId const node = nodes_.intern(nodes_.operation(op, operands[0], operands[1], operands[2]));
  if (like_.size() <= node) like_.resize(node + std::size_t{1}, no_node);
  like_[node] = like;
  return node;
}

Step BodyBuilder::finish(std::uint32_t count, std::optional<Nest> const &nest) {
  Step step{{}, count, std::move(leaves_), std::move(stores_), nest};
  Graph &body = step.body;
  body.kernel = graph_->kernel;
  body.tables = graph_->tables;
  body.locations = graph_->locations;
  body.names = graph_->names;
  body.nodes = nodes_.release();
  like_.resize(body.nodes.size(), no_node);
  for (NodeId like : like_) {
    if (!graph_->node_location.empty())
      body.node_location.push_back(like == no_node ? no_location : graph_->node_location[like]);
    if (!graph_->node_exact.empty()) body.node_exact.push_back(like == no_node ? char{0} : graph_->node_exact[like]);
    if (!graph_->node_name.empty()) body.node_name.push_back(like == no_node ? no_name : graph_->node_name[like]);
  }
  auto const count_of = [](std::size_t size) { return static_cast<std::uint32_t>(size); };
  body.inputs = {{"leaves", {step.leaves.size()}, 0, count_of(step.leaves.size())}};
  body.input_values.assign(step.leaves.size(), 0.0);
  for (Store const &store : step.stores) body.results.push_back(store.value);
  for (Leaf const &leaf : step.leaves)
    if (leaf.kind == Leaf::Kind::carried) body.results.push_back(leaf.next);
  body.outputs = {{"stores", {body.results.size()}, 0, count_of(body.results.size())}};
  return step;
}

} // namespace symreal::reroll
