#include "engine/plan/schedule/list_scheduling.h"

#include "engine/graph/opaque.h"
#include "engine/ops/cost_model.h"
#include "engine/plan/schedule/order.h"
#include "engine/plan/schedule/rows.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace symreal {

namespace {

constexpr std::size_t registers = 16;       // for numbers: x86-64 with SSE and AVX; AArch64 has 32
constexpr std::size_t longest = 200'000;    // the lists of a longer body would take as much memory as its graph
constexpr double least_library_cost = 10.0; // cheaper operations compile to instructions

class ListScheduling {
public:
  ListScheduling(Graph const &graph, std::vector<char> const &is_read, FunctionBody &body)
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
  FunctionBody &body_;
  std::size_t count_;
  std::vector<Statement> statement_;     // per node: the statement that sets its variable
  Rows reads_, readers_;                 // per statement
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

void schedule_for_registers(Graph const &graph, std::vector<char> const &is_read, FunctionBody &body) {
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
