#include "schedule/order.h"

#include <algorithm>

namespace symreal {

namespace {

class Ordering {
public:
  Ordering(Graph const &graph, std::vector<char> const &is_read, Placement const &placement, FunctionBody &body)
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

  // Depth first, with a stack of its own.
  void visit(NodeId root) {
    stack_.assign(1, root);
    while (!stack_.empty()) {
      NodeId const id = stack_.back();
      if (state_[id] == State::waiting) {
        state_[id] = State::open;
        push_needed(id);
        continue;
      }
      stack_.pop_back();
      if (state_[id] != State::open) continue;
      state_[id] = State::done;
      body_.variables.push_back(id);
      body_.region.push_back(region(id));
    }
  }

  RegionId region(NodeId id) const {
    return placement_.regions.is_gate(id) ? placement_.regions.of_gate(id) : placement_.of_node[id];
  }

  // The oldest on top.
  void push_needed(NodeId id) {
    std::size_t const first = stack_.size();
    auto push = [&](NodeId needed) {
      if (state_[needed] == State::nested || state_[needed] == State::done) return;
      internal_check(state_[needed] == State::waiting);
      stack_.push_back(needed);
    };
    for (Literal const &literal : placement_.regions.literals(region(id))) push(literal.condition);
    if (!placement_.regions.is_gate(id) && !is_read_[id])
      for (NodeId operand : graph_.nodes[id].operand)
        if (operand != no_node)
          for_each_read(
              graph_, operand, [&](NodeId read) { return state_[read] != State::nested; },
              [&](NodeId read) { return is_read_[read] != 0; }, push);
    std::sort(stack_.begin() + static_cast<std::ptrdiff_t>(first), stack_.end(), std::greater<>());
  }

  Graph const &graph_;
  std::vector<char> const &is_read_;
  Placement const &placement_;
  FunctionBody &body_;
  std::vector<State> state_;
  std::vector<NodeId> stack_;
};

} // namespace

void order(Graph const &graph, std::vector<char> const &is_read, Placement const &placement, FunctionBody &body) {
  if (placement.conditional())
    Ordering(graph, is_read, placement, body).run();
  else
    body.region.assign(body.variables.size(), everywhere);
}

} // namespace symreal
