#include "engine/plan/schedule/delay.h"

#include "engine/graph/opaque.h"
#include "engine/plan/schedule/order.h"

#include <algorithm>

namespace symreal {

namespace {

class Delay {
public:
  Delay(Graph const &graph, std::vector<char> const &is_read, FunctionBody &body)
      : graph_(graph),
        is_read_(is_read),
        body_(body),
        statement_(body.regions.value_count(), nowhere),
        stays_(body.variables.size(), 0),
        first_place_(body.variables.size(), nowhere),
        place_(body.variables.size()),
        lives_to_(body.variables.size(), 0) {
    for (std::size_t k = 0; k < body.variables.size(); ++k) statement_[body.variables[k]] = k;
  }

  void run(std::vector<NodeId> const &conditions) {
    for (NodeId const condition : conditions) for_each_variable(condition, [&](std::size_t k) { stays_[k] = 1; });
    for (std::size_t k = body_.variables.size(); k-- > 0;) {
      place_[k] = k;
      if (may_move(k) && all_live_to(k, first_place_[k])) place_[k] = first_place_[k];
      for_each_operand(k, [&](std::size_t read) {
        first_place_[read] = std::min(first_place_[read], place_[k]);
        lives_to_[read] = std::max(lives_to_[read], place_[k]);
      });
    }
    move();
  }

private:
  static constexpr std::size_t nowhere = ~std::size_t{0};

  template <class Visit> void for_each_variable(NodeId use, Visit const &visit) const {
    for_each_read(
        graph_, use, [&](NodeId id) { return statement_[id] != nowhere; }, [&](NodeId id) { return is_read_[id] != 0; },
        [&](NodeId id) { visit(statement_[id]); });
  }
  template <class Visit> void for_each_operand(std::size_t k, Visit const &visit) const {
    NodeId const id = body_.variables[k];
    if (is_read_[id]) return;
    for (NodeId const operand : graph_.nodes[id].operand)
      if (operand != no_node) for_each_variable(operand, visit);
  }

  bool may_move(std::size_t k) const {
    return !stays_[k] && first_place_[k] != nowhere && !is_call(graph_.nodes[body_.variables[k]].op);
  }
  bool all_live_to(std::size_t k, std::size_t place) const {
    bool all = true;
    for_each_operand(k, [&](std::size_t read) { all = all && lives_to_[read] >= place; });
    return all;
  }

  // Moves the statements; at one place, moved ones keep their order and precede the one that stays.
  void move() {
    std::vector<NodeId> const old = body_.variables;
    std::vector<std::size_t> begin(old.size() + 1, 0);
    for (std::size_t const place : place_) ++begin[place + 1];
    for (std::size_t k = 0; k < old.size(); ++k) begin[k + 1] += begin[k];
    for (std::size_t k = 0; k < old.size(); ++k) body_.variables[begin[place_[k]]++] = old[k];
  }

  Graph const &graph_;
  std::vector<char> const &is_read_;
  FunctionBody &body_;
  std::vector<std::size_t> statement_; // per node
  std::vector<char> stays_;
  std::vector<std::size_t> first_place_; // per statement: place of the first reader
  std::vector<std::size_t> place_;       // the statement that it moves in front of, or itself
  std::vector<std::size_t> lives_to_;    // the last known place of a reader
};

} // namespace

void delay(Graph const &graph, std::vector<char> const &is_read, std::vector<NodeId> const &conditions,
           FunctionBody &body) {
  if (is_straight(graph, body)) Delay(graph, is_read, body).run(conditions);
}

} // namespace symreal
