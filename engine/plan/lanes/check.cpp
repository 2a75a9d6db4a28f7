#include "engine/plan/lanes/check.h"

#include "engine/plan/schedule/numbering.h"

#include <fmt/format.h>

namespace symreal::lanes {

namespace {

using Value = NumberedValue;

class LaneCheck {
public:
  LaneCheck(ScalarFunction const &function, LaneFunction const &lanes) : function_(function), lanes_(lanes) {}

  std::string run() {
    std::size_t const count = function_.graph().nodes.size();
    expected_.resize(count);
    alone_.resize(count);
    for (NodeId id = 0; id < count; ++id) expected_[id] = value_of(id, expected_);
    vectors_.resize(lanes_.vectors.size());
    for (Item const &item : lanes_.order) {
      if (!item.is_vector) {
        alone_[item.id] = alone(item.id);
        if (alone_[item.id] != expected_[item.id]) return fmt::format("node {} is another value", item.id);
        continue;
      }
      std::vector<NodeId> const &nodes = lanes_.vectors[item.id].nodes;
      for (std::size_t lane = 0; lane < lanes_.width; ++lane) {
        vectors_[item.id].push_back(value(lanes_.vectors[item.id], lane));
        bool const is_right = nodes[lane] == no_node || vectors_[item.id][lane] == expected_[nodes[lane]];
        if (!is_right) return fmt::format("lane {} of vector {} is another value", lane, item.id);
      }
    }
    return stores();
  }

private:
  Value leaf(NodeId id) {
    if (function_.is_constant(id)) return numbering_.constant(function_.node(id).value());
    Element const element = function_.element(id);
    return numbering_.element(static_cast<std::uint32_t>(element.array), element.index);
  }
  Value value_of(NodeId id, std::vector<Value> const &values) {
    if (!function_.is_computed(id)) return leaf(id);
    Node const &node = function_.node(id);
    std::array<Value, 3> operands;
    for (std::size_t i = 0; i < arity(node.op); ++i)
      if (node.operand[i] != no_node) operands[i] = values[node.operand[i]];
    return numbering_.operation(node.op, operands);
  }

  // Value of a node at its use; unknown if it has not been computed yet.
  Value used(NodeId id) {
    if (!function_.is_computed(id)) return leaf(id);
    Lane const &lane = lanes_.lane[id];
    if (!lane.is_given()) return alone_[id];
    return lane_of(lane.vector, lane.lane);
  }
  Value lane_of(VectorId vector, std::size_t lane) const {
    return vectors_[vector].size() == lanes_.width ? vectors_[vector][lane] : Value{};
  }
  Value alone(NodeId id) {
    Node const &node = function_.node(id);
    std::array<Value, 3> operands;
    for (std::size_t i = 0; i < arity(node.op); ++i)
      if (node.operand[i] != no_node) operands[i] = used(node.operand[i]);
    return numbering_.operation(node.op, operands);
  }

  Value value(Vector const &vector, std::size_t lane) {
    switch (vector.form) {
    case Vector::Form::operation: return operation(vector, lane);
    case Vector::Form::load: return numbering_.element(static_cast<std::uint32_t>(vector.array), vector.first + lane);
    case Vector::Form::shuffle: {
      std::size_t const from = vector.from[lane];
      return lane_of(vector.operand[from / lanes_.width], from % lanes_.width);
    }
    case Vector::Form::splat: return used(vector.nodes[0]);
    case Vector::Form::constants:
    case Vector::Form::build: return used(vector.nodes[lane]);
    }
    return {};
  }
  Value operation(Vector const &vector, std::size_t lane) {
    std::array<Value, 3> operands;
    for (std::size_t i = 0; i < arity(vector.op); ++i) operands[i] = lane_of(vector.operand[i], lane);
    if (!vector.subtracts.empty() && vector.subtracts[lane]) operands[1] = -operands[1];
    return numbering_.operation(vector.op, operands);
  }

  std::string stores() {
    std::vector<NodeId> const &results = function_.results();
    std::vector<char> stored(results.size(), 0);
    for (Store const &store : lanes_.stores)
      for (std::size_t lane = 0; lane < lanes_.width; ++lane) {
        if (lane_of(store.vector, lane) != expected_[results[store.first + lane]])
          return fmt::format("result {} is another value", store.first + lane);
        stored[store.first + lane] = 1;
      }
    for (std::size_t slot = 0; slot < results.size(); ++slot) {
      if (stored[slot] == lanes_.is_stored_alone(slot)) return fmt::format("result {} is not stored once", slot);
      if (!stored[slot] && used(results[slot]) != expected_[results[slot]])
        return fmt::format("result {} is another value", slot);
    }
    for (NodeId condition : function_.conditions())
      if (used(condition) != expected_[condition]) return fmt::format("node {} is not computed", condition);
    return {};
  }

  ScalarFunction const &function_;
  LaneFunction const &lanes_;
  Numbering numbering_;
  std::vector<Value> expected_, alone_;
  std::vector<std::vector<Value>> vectors_;
};

} // namespace

std::string find_difference(ScalarFunction const &function, LaneFunction const &lanes) {
  return LaneCheck(function, lanes).run();
}

} // namespace symreal::lanes
