#include "engine/plan/schedule/order.h"

#include "engine/graph/graph.h"
#include "engine/ops/operation.h"
#include "engine/plan/schedule/dependences.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace symreal {

namespace {

class Ordering {
public:
  Ordering(Graph const &graph, std::vector<char> const &is_read, Placement &placement, PlanFunction &body)
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
  PlanFunction &body_;
  std::vector<State> state_;
  std::vector<NodeId> stack_;
  static constexpr int most_cycles = 50;
  int cycles_ = 0;
};

class Delay {
public:
  Delay(Graph const &graph, std::vector<char> const &is_read, PlanFunction &body)
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
  PlanFunction &body_;
  std::vector<std::size_t> statement_; // per node
  std::vector<char> stays_;
  std::vector<std::size_t> first_place_; // per statement: place of the first reader
  std::vector<std::size_t> place_;       // the statement that it moves in front of, or itself
  std::vector<std::size_t> lives_to_;    // the last known place of a reader
};

constexpr std::size_t registers = 16;       // for numbers: x86-64 with SSE and AVX; AArch64 has 32
constexpr std::size_t longest = 200'000;    // the lists of a longer body would take as much memory as its graph
constexpr double least_library_cost = 10.0; // cheaper operations compile to instructions

// Transpose: row k lists, in ascending order, the rows that contain k.
StatementRows transposed(StatementRows const &rows) {
  StatementRows result{std::vector<std::size_t>(rows.size() + 1, 0), std::vector<std::uint32_t>(rows.all.size())};
  for (std::uint32_t const k : rows.all) ++result.first[k + 1];
  for (std::size_t k = 0; k < rows.size(); ++k) result.first[k + 1] += result.first[k];
  std::vector<std::size_t> next = result.first;
  for (std::uint32_t row = 0; row < rows.size(); ++row)
    for (std::uint32_t const k : rows[row]) result.all[next[k]++] = row;
  return result;
}

class ListScheduling {
public:
  ListScheduling(Graph const &graph, std::vector<char> const &is_read, PlanFunction &body)
      : graph_(graph),
        is_read_(is_read),
        body_(body),
        count_(body.variables.size()),
        statement_(graph.nodes.size(), nowhere),
        unread_(count_, 0),
        waits_for_(count_, 0),
        dies_(count_, 0),
        height_(count_, 0),
        call_of_(count_, no_node),
        placed_(count_, 0) {
    for (std::size_t k = 0; k < count_; ++k) statement_[body.variables[k]] = static_cast<Statement>(k);
    for (Statement k = 0; k < count_; ++k) read_expression(k);
    readers_ = transposed(reads_);
    for (Statement k = static_cast<Statement>(count_); k-- > 0;) {
      double below = 0;
      for (Statement const reader : readers_[k]) below = std::max(below, height_[reader]);
      height_[k] += below;
      unread_[k] = static_cast<std::uint32_t>(readers_[k].size());
      waits_for_[k] = static_cast<std::uint32_t>(reads_[k].size());
    }
  }

  // Cost of an order beyond its operations: if it will be cut into parts, about the number of values that live from
  // part to part; else the number of spilled values, summed over all points.
  std::size_t cost(std::vector<NodeId> const &order) const {
    std::vector<std::size_t> place(count_), unread(count_);
    for (std::size_t k = 0; k < count_; ++k) place[statement_[order[k]]] = k;
    for (std::size_t k = 0; k < count_; ++k) unread[k] = readers_[k].size();
    std::size_t live = 0, cost = 0;
    for (NodeId const id : order) {
      Statement const k = statement_[id];
      if (count_ > usual_part_length) {
        auto const is_later = [&](Statement reader) {
          return place[reader] / usual_part_length > place[k] / usual_part_length;
        };
        cost += std::ranges::any_of(readers_[k], is_later);
        continue;
      }
      for (Statement const read : reads_[k]) live -= --unread[read] == 0;
      live += unread[k] != 0;
      if (live > registers) cost += live - registers;
    }
    return cost;
  }

  std::vector<NodeId> run() {
    std::vector<NodeId> order;
    order.reserve(count_);
    for (Statement k = 0; k < count_; ++k) {
      note_last_reads(k);
      if (waits_for_[k] == 0) add_ready(k);
    }
    while (order.size() < count_) {
      Statement const next = take();
      order.push_back(body_.variables[next]);
      place(next);
    }
    return order;
  }

private:
  using Statement = std::uint32_t;
  static constexpr Statement nowhere = ~Statement{0};
  // Heap keys: the largest comes first, with ties in recording order.
  using ByHeight = std::tuple<double, std::uint32_t, std::uint32_t>; // height, dying, - place
  using ByDeaths = std::tuple<std::uint32_t, double, std::uint32_t>; // dying, height, - place
  using ByOperand = std::tuple<std::uint32_t, std::uint32_t>;        // - operand, - place

  // Finds the statements that it reads, each once; its latency; and its library call.
  void read_expression(Statement k) {
    NodeId const root = body_.variables[k];
    double latency = 0;
    SmallStack<std::pair<NodeId, double>> open;
    open.push({root, 0});
    while (!open.empty()) {
      auto const [id, after] = open.pop();
      if (id != root && statement_[id] != nowhere) {
        reads_.all.push_back(statement_[id]);
        continue;
      }
      if (is_read_[id]) continue;
      Node const &node = graph_.nodes[id];
      double const through = after + usual_costs().latency_of(node.op);
      latency = std::max(latency, through);
      if (usual_costs()[node.op] >= least_library_cost && info(node.op).form == Form::call)
        call_of_[k] = node.operand[0];
      for (NodeId const operand : node.operand)
        if (operand != no_node) open.push({operand, through});
    }
    height_[k] = latency;
    std::ranges::subrange row(reads_.all.begin() + static_cast<std::ptrdiff_t>(reads_.first[k]), reads_.all.end());
    std::ranges::sort(row);
    reads_.all.erase(std::ranges::unique(row).begin(), reads_.all.end());
    reads_.end_row();
  }

  // Counts for a value with one unread reader that this reader ends its live range.
  void note_last_reads(Statement k) {
    if (unread_[k] != 1) return;
    for (Statement const reader : readers_[k]) {
      if (placed_[reader]) continue;
      ++dies_[reader];
      if (waits_for_[reader] == 0 && is_listed(reader)) by_deaths_.emplace(dies_[reader], height_[reader], ~reader);
    }
  }
  bool is_listed(Statement k) const { return call_of_[k] == no_node; }

  void add_ready(Statement k) {
    if (!is_listed(k)) return calls_.emplace(~call_of_[k], ~k), void();
    by_height_.emplace(height_[k], dies_[k], ~k);
    by_deaths_.emplace(dies_[k], height_[k], ~k);
  }

  Statement take() {
    if (!calls_.empty()) {
      Statement const k = ~std::get<1>(calls_.top());
      calls_.pop();
      return k;
    }
    return live_ > registers ? take_from(by_deaths_) : take_from(by_height_);
  }
  // Skips entries of placed statements, and thereby stale ones: those of a statement are smaller than its newest.
  template <class Heap> Statement take_from(Heap &heap) {
    while (true) {
      Statement const k = ~std::get<2>(heap.top());
      heap.pop();
      if (!placed_[k]) return k;
    }
  }

  void place(Statement k) {
    placed_[k] = 1;
    live_ += unread_[k] != 0;
    for (Statement const read : reads_[k]) {
      live_ -= --unread_[read] == 0;
      note_last_reads(read);
    }
    for (Statement const reader : readers_[k])
      if (--waits_for_[reader] == 0) add_ready(reader);
  }

  Graph const &graph_;
  std::vector<char> const &is_read_;
  PlanFunction &body_;
  std::size_t count_;
  std::vector<Statement> statement_;     // per node: the statement that sets its variable
  StatementRows reads_, readers_;        // per statement
  std::vector<std::uint32_t> unread_;    // per statement: unplaced readers
  std::vector<std::uint32_t> waits_for_; // unplaced statements that it reads
  std::vector<std::uint32_t> dies_;      // live ranges that it ends
  std::vector<double> height_;           // the longest path from its operands to a result
  std::vector<NodeId> call_of_;          // operand of its library call
  std::vector<char> placed_;
  std::size_t live_ = 0;
  std::priority_queue<ByHeight> by_height_;
  std::priority_queue<ByDeaths> by_deaths_;
  std::priority_queue<ByOperand> calls_;
};

} // namespace

void order(Graph const &graph, std::vector<char> const &is_read, Placement &placement, PlanFunction &body) {
  if (placement.conditional())
    Ordering(graph, is_read, placement, body).run();
  else
    body.region.assign(body.variables.size(), everywhere);
}

void delay(Graph const &graph, std::vector<char> const &is_read, std::vector<NodeId> const &conditions,
           PlanFunction &body) {
  if (is_straight(graph, body)) Delay(graph, is_read, body).run(conditions);
}

void schedule_for_registers(Graph const &graph, std::vector<char> const &is_read, PlanFunction &body) {
  if (!is_straight(graph, body) || !graph.externals.empty() || body.variables.size() > longest) return;
  ListScheduling scheduling(graph, is_read, body);
  std::size_t const cost = scheduling.cost(body.variables);
  if (cost == 0) return;
  std::vector<NodeId> order = scheduling.run();
  // Recording order accesses inputs and outputs sequentially, which is worth a tenth in long bodies.
  std::size_t const limit = body.variables.size() > usual_part_length ? cost - cost / 10 : cost;
  if (scheduling.cost(order) < limit) body.variables = std::move(order);
}

} // namespace symreal
