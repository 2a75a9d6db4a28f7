// Random straight-line programs of all operations on numbers.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"

#include <random>
#include <span>
#include <vector>

namespace symreal::test {

inline bool is_on_numbers(OperationInfo const &row) {
  using namespace flag;
  return row.domain != Domain::integer && !row.has(OPAQUE | STRUCTURE | EFFECT | WIDE | TAKES_WIDE) &&
         !row.name.starts_with("int");
}

class RandomGraph {
public:
  // `numbers`: the constants that it may have.
  RandomGraph(std::uint64_t seed, std::span<double const> numbers) : random_(seed), constants_(numbers) {
    for (std::uint32_t slot = 0; slot < 4; ++slot) numbers_.push_back(table_.intern(Node::input(slot)));
    for (std::uint32_t slot = 0; slot < 2; ++slot) numbers_.push_back(table_.intern(Node::parameter(slot)));
    truths_.push_back(table_.intern(table_.operation(Op::lt, numbers_[0], numbers_[1])));
    for (std::size_t count = 5 + random_() % 40; count > 0; --count) add();
  }

  Graph graph() {
    Graph graph;
    graph.kernel = "k";
    graph.inputs = {{.label = "x", .extents = {4}, .first = 0, .count = 4}};
    graph.parameters = {{.label = "p", .extents = {2}, .first = 0, .count = 2}};
    graph.input_values.assign(4, 0.5);
    graph.parameter_values.assign(2, 0.5);
    graph.outputs = {{.label = "y", .extents = {3}, .first = 0, .count = 3}};
    for (int k = 0; k < 3; ++k) graph.results.push_back(numbers_[numbers_.size() - 1 - random_() % 4]);
    if (random_() % 4 == 0) graph.guards.push_back({.condition = truths_.back(), .text = "holds"});
    graph.nodes = table_.release();
    return graph;
  }

private:
  // Few nodes to choose from: so operands are equal, and rules have something to find.
  NodeId any(std::vector<NodeId> const &nodes) {
    return nodes[nodes.size() - 1 - random_() % std::min<std::size_t>(nodes.size(), 8)];
  }
  NodeId number() {
    if (random_() % 6 == 0) return table_.constant(constants_[random_() % constants_.size()]);
    return random_() % 8 == 0 ? any(truths_) : any(numbers_);
  }

  void add() {
    static std::vector<OperationInfo> const rows = [] {
      std::vector<OperationInfo> all;
      for (OperationInfo const &row : operations())
        if (is_on_numbers(row)) all.push_back(row);
      return all;
    }();
    constexpr Op frequent[] = {Op::add, Op::sub, Op::mul, Op::div, Op::neg, Op::abs, Op::lt, Op::select};
    OperationInfo const &row =
        random_() % 2 == 0 ? info(frequent[random_() % std::size(frequent)]) : rows[random_() % rows.size()];
    NodeId operand[3] = {no_node, no_node, no_node};
    for (std::size_t k = 0; k < row.arity; ++k) {
      bool const is_truth = row.has(flag::LOGICAL) || (row.form == Form::select && k == 0);
      operand[k] = is_truth ? any(truths_) : number();
    }
    NodeId const made = table_.intern(table_.operation(row.op, operand[0], operand[1], operand[2]));
    (row.has(flag::BOOLEAN) ? truths_ : numbers_).push_back(made);
  }

  std::mt19937_64 random_;
  std::span<double const> constants_;
  NodeTable table_;
  std::vector<NodeId> numbers_, truths_;
};

} // namespace symreal::test
