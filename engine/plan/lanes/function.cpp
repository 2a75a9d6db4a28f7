#include "engine/plan/lanes/function.h"

namespace symreal::lanes {

Function::Function(Schedule const &plan, std::size_t width) : plan_(plan), width_(width) {
  for (Guard const &guard : plan.graph->guards) conditions_.push_back(guard.condition);
}

bool Function::can_be_packed(NodeId id) const {
  if (!is_computed(id)) return false;
  Op const op = node(id).op;
  return op == Op::add || op == Op::sub || op == Op::mul || op == Op::div || op == Op::neg;
}

} // namespace symreal::lanes
