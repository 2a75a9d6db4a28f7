// Scalar function: function compute of a plan, whose operations are packed into vectors.
#pragma once

#include "engine/plan/plan.h"

namespace symreal::lanes {

class ScalarFunction {
public:
  // `plan` must outlive this object.
  ScalarFunction(Plan const &plan, std::size_t width) : plan_(plan), width_(width) {
    for (Guard const &guard : plan.graph->guards) conditions_.push_back(guard.condition);
  }

  Graph const &graph() const { return *plan_.graph; }
  Node const &node(NodeId id) const { return graph().nodes[id]; }
  std::size_t width() const { return width_; }
  std::vector<NodeId> const &results() const { return plan_.compute().results; }
  std::vector<NodeId> const &conditions() const { return conditions_; } // of guards

  bool is_constant(NodeId id) const { return node(id).is_constant(); }
  bool is_element(NodeId id) const { return plan_.element(id).has_value(); }
  Element element(NodeId id) const {
    std::optional<Element> const element = plan_.element(id);
    internal_check(element.has_value());
    return *element;
  }
  std::size_t extent(Array array) const { return plan_.extent(array); }
  // Whether an operation of this function computes the node.
  bool is_computed(NodeId id) const { return !is_constant(id) && !is_element(id); }
  // Whether vectors have the operation: exact or correctly rounded in each lane.
  bool can_be_packed(NodeId id) const {
    if (!is_computed(id)) return false;
    Op const op = node(id).op;
    return op == Op::add || op == Op::sub || op == Op::mul || op == Op::div || op == Op::neg;
  }

private:
  Plan const &plan_;
  std::size_t width_;
  std::vector<NodeId> conditions_;
};

} // namespace symreal::lanes
