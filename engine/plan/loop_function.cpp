#include "engine/plan/loop_function.h"

#include <cstdlib>

namespace symreal::reroll {

double value_at(Leaf const &leaf, std::uint32_t iteration, std::optional<Nest> const &nest) {
  return leaf.values[(leaf.by_turn && nest ? turn_of(*nest, iteration).outer : iteration) % leaf.values.size()];
}

std::optional<Nest> nest_of(LoopStep const &step) {
  if (step.nest) return step.nest;
  std::vector<Access const *> accesses;
  for (Leaf const &leaf : step.leaves) accesses.push_back(&leaf.access);
  for (Store const &store : step.stores) accesses.push_back(&store.access);
  return nest_of(step.count, accesses);
}

namespace {

constexpr std::int64_t most_unrolled = 16; // iterations of an inner loop: gcc's max-completely-peel-times

// Access as an affine index with the innermost loop's step; nullopt if it needs an index table.
std::optional<NestedAccess> in_loop(Access const &access, std::optional<Nest> const &nest) {
  if (!access.is_listed()) return NestedAccess{access.first, 0, access.step};
  return nest ? nested(access, *nest) : std::nullopt;
}

bool are_neighbours(NestedAccess const &a, NestedAccess const &b) {
  return a.inner == b.inner && a.outer == b.outer && std::abs(a.first - b.first) < std::abs(a.inner);
}

} // namespace

bool is_side_by_side(LoopStep const &step) {
  if (step.count == 1) return false;
  if (std::ranges::any_of(step.leaves, [](Leaf const &leaf) { return leaf.is_carried; })) return false;
  std::optional<Nest> const nest = nest_of(step);
  if (nest && nest->growth == 0 && nest->inner <= most_unrolled) return false;
  std::vector<std::pair<bool, NestedAccess>> stores;
  for (Store const &store : step.stores) {
    std::optional<NestedAccess> const here = in_loop(store.access, nest);
    if (!here || here->inner == 0) return false;
    for (auto const &[is_result, other] : stores)
      if (is_result == store.is_result && are_neighbours(*here, other)) return false;
    stores.emplace_back(store.is_result, *here);
  }
  return true;
}

NodeId BodyBuilder::operation(Op op, std::array<NodeId, 3> const &operands, NodeId like) {
  NodeId const node = nodes_.intern(nodes_.operation(op, operands[0], operands[1], operands[2]));
  if (like_.size() <= node) like_.resize(node + std::size_t{1}, no_node);
  like_[node] = like;
  return node;
}

LoopStep BodyBuilder::finish(std::uint32_t count, std::optional<Nest> const &nest) {
  LoopStep step{{}, count, std::move(leaves_), std::move(stores_), nest};
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
    if (leaf.is_carried) body.results.push_back(leaf.next);
  body.outputs = {{"stores", {body.results.size()}, 0, count_of(body.results.size())}};
  return step;
}

} // namespace symreal::reroll
