#include "engine/plan/schedule/order.h"

#include <algorithm>

namespace symreal {

namespace {

class Ordering {
public:
  Ordering(Graph const &graph, std::vector<char> const &is_read, Placement &placement, FunctionBody &body)
      : graph_(graph),
        is_read_(is_read),
        placement_(placement),
        body_(body),
        state_(placement.regions.value_count(), State::nested) {
    for (NodeId id : body.variables) state_[id] = State::waiting;
    std::fill(state_.begin() + static_cast<std::ptrdiff_t>(graph.nodes.size()), state_.end(), State::waiting);
  }

  void run() {
    std::vector<NodeId> const variables = std::move(body_.variables);
    body_.variables.clear();
    for (NodeId id : variables) visit(id);
  }

private:
  enum class State : char { nested, waiting, open, done };

  // Depth-first search with an explicit stack.
  void visit(NodeId root) {
    stack_.assign(1, root);
    while (!stack_.empty()) {
      NodeId const id = stack_.back();
      if (state_[id] == State::waiting) {
        state_[id] = State::open;
        if (!push_needed(id)) begin_again(root);
        continue;
      }
      stack_.pop_back();
      if (state_[id] != State::open) continue;
      state_[id] = State::done;
      body_.variables.push_back(id);
      body_.region.push_back(region(id));
    }
  }

  // Open statements form a cycle through a gate of alternatives: releases the newest such gate and restarts.
  void begin_again(NodeId root) {
    bool released = false;
    for (; !stack_.empty(); stack_.pop_back()) {
      NodeId const id = stack_.back();
      if (state_[id] != State::open) continue;
      state_[id] = State::waiting;
      if (!released && is_choice(id)) placement_.regions.release(id);
      released = released || is_choice(id);
    }
    internal_check(released);
    if (++cycles_ == most_cycles) // more cycles cost more than their gates save
      for (std::size_t id = graph_.nodes.size(); id < state_.size(); ++id)
        if (state_[id] == State::waiting && is_choice(static_cast<NodeId>(id)))
          placement_.regions.release(static_cast<NodeId>(id));
    stack_.assign(1, root);
  }

  bool is_choice(NodeId id) const {
    return placement_.regions.is_gate(id) && !placement_.regions.alternatives(id).empty();
  }

  RegionId region(NodeId id) const {
    return placement_.regions.is_gate(id) ? placement_.regions.of_gate(id) : placement_.of_node[id];
  }

  // Pushes the operands, the oldest on top; false if one of them is open.
  bool push_needed(NodeId id) {
    Regions const &regions = placement_.regions;
    std::size_t const first = stack_.size();
    bool possible = true;
    auto push = [&](NodeId needed) {
      possible = possible && state_[needed] != State::open;
      if (state_[needed] == State::waiting) stack_.push_back(needed);
    };
    for (Literal const &literal : regions.literals(region(id))) push(literal.condition);
    if (regions.is_gate(id)) {
      for (RegionId alternative : regions.alternatives(id))
        for (Literal const &literal : regions.literals(alternative)) push(literal.condition);
    } else if (!is_read_[id]) {
      for (NodeId operand : graph_.nodes[id].operand)
        if (operand != no_node)
          for_each_read(
              graph_, operand, [&](NodeId read) { return state_[read] != State::nested; },
              [&](NodeId read) { return is_read_[read] != 0; }, push);
    }
    std::sort(stack_.begin() + static_cast<std::ptrdiff_t>(first), stack_.end(), std::greater<>());
    return possible;
  }

  Graph const &graph_;
  std::vector<char> const &is_read_;
  Placement &placement_;
  FunctionBody &body_;
  std::vector<State> state_;
  std::vector<NodeId> stack_;
  static constexpr int most_cycles = 50;
  int cycles_ = 0;
};

} // namespace

void order(Graph const &graph, std::vector<char> const &is_read, Placement &placement, FunctionBody &body) {
  if (placement.conditional())
    Ordering(graph, is_read, placement, body).run();
  else
    body.region.assign(body.variables.size(), everywhere);
}

std::vector<char> needed_operations(Schedule const &plan, bool in_compute, std::vector<NodeId> const &roots) {
  Graph const &graph = *plan.graph;
  std::vector<char> needed(graph.nodes.size(), 0);
  for (NodeId const root : roots) needed[root] = 1;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    if (!needed[id]) continue;
    if (is_read(plan, in_compute, static_cast<NodeId>(id))) {
      needed[id] = 0;
      continue;
    }
    for (NodeId const operand : graph.nodes[id].operand)
      if (operand != no_node) needed[operand] = 1;
  }
  return needed;
}

} // namespace symreal
