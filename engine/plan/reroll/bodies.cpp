#include "engine/plan/reroll/bodies.h"

#include "engine/graph/evaluate.h"
#include "engine/plan/reroll/recurrences.h"
#include "engine/plan/reroll/roles.h"
#include "engine/plan/reroll/signs.h"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

namespace symreal::reroll {

namespace {

bool is_on_circle(Leaf const &leaf) { return leaf.array == Array::sine || leaf.array == Array::cosine; }

// Whether all accessed angles are inputs: passes may read an angle itself, which a body can only do for inputs.
bool are_of_inputs(Access const &access, std::uint32_t count, Angles const &angles) {
  for (std::uint32_t k = 0; k < count; ++k)
    if (access.at(k) >= angles.inputs.size()) return false;
  return true;
}

std::array<NodeId, 3> moved(Node const &node, std::vector<NodeId> const &now) {
  std::array<NodeId, 3> operands = {no_node, no_node, no_node};
  for (unsigned i = 0; i < arity(node.op); ++i) operands[i] = now[node.operand[i]];
  return operands;
}

// Conversion of a body to the graph that passes work on, and back.
class Improver {
public:
  Improver(LoopStep const &step, Angles const &angles) : step_(step), angles_(angles) {
    for (std::uint32_t k = 0; k < step.leaves.size(); ++k) {
      Leaf const &leaf = step.leaves[k];
      auto const of_same_angle = [&](Leaf const &other) { return is_on_circle(other) && other.access == leaf.access; };
      if (leaf.array == Array::values)
        tables_.push_back(k);
      else if (is_on_circle(leaf) && are_of_inputs(leaf.access, step.count, angles))
        angle_[k] = static_cast<std::uint32_t>(std::ranges::find_if(step.leaves, of_same_angle) - step.leaves.begin());
    }
  }

  Graph graph() const {
    Graph const &body = step_.body;
    Graph graph = without_nodes(body);
    NodeTable table;
    std::vector<NodeId> now(body.nodes.size(), no_node);
    for (NodeId id = 0; id < body.nodes.size(); ++id) {
      Node const &node = body.nodes[id];
      if (node.is_constant()) {
        now[id] = table.constant(node.value());
      } else if (node.op == Op::input) {
        now[id] = leaf(node.slot(), table);
      } else {
        std::array<NodeId, 3> const operand = moved(node, now);
        now[id] = table.intern(table.operation(node.op, operand[0], operand[1], operand[2]));
      }
    }
    graph.nodes = table.release();
    carry_over(body, now, graph);
    graph.parameters = {{"values", {tables_.size()}, 0, static_cast<std::uint32_t>(tables_.size())}};
    for (std::uint32_t const k : tables_) graph.parameter_values.push_back(step_.leaves[k].values.front());
    if (tables_.empty()) graph.parameters.clear();
    return graph;
  }

  LoopStep step(Graph const &graph) {
    std::vector<char> const needed = needed_nodes(graph);
    std::vector<std::vector<double>> const rows = table_rows(graph, needed);
    BodyBuilder body(graph);
    std::vector<NodeId> now(graph.nodes.size(), no_node), carried(step_.leaves.size(), no_node);
    for (NodeId id = 0; id < graph.nodes.size(); ++id) {
      Node const &node = graph.nodes[id];
      if (!needed[id]) continue;
      if (is_table_[id]) {
        now[id] = column(rows, id, body);
      } else if (node.is_constant()) {
        now[id] = body.constant(node.value());
      } else if (node.op == Op::input) {
        if (is_angle(node.slot()) && !is_read_[id]) continue;
        now[id] = body.leaf(is_angle(node.slot()) ? input_of(node.slot()) : step_.leaves[node.slot()]);
        if (step_.leaves[node.slot()].is_carried) carried[node.slot()] = now[id];
      } else if (is_element(graph, node)) {
        Array const array = node.op == Op::sin ? Array::sine : Array::cosine;
        now[id] = body.leaf({array, step_.leaves[graph.nodes[node.operand[0]].slot()].access});
      } else {
        now[id] = body.operation(node.op, moved(node, now), id);
      }
    }
    std::size_t result = 0;
    for (Store const &store : step_.stores) body.store(now[graph.results[result++]], store.is_result, store.access);
    for (std::uint32_t k = 0; k < step_.leaves.size(); ++k) {
      if (!step_.leaves[k].is_carried) continue;
      NodeId const next = graph.results[result++];
      if (carried[k] != no_node) body.carry(carried[k], now[next]);
    }
    return body.finish(step_.count, step_.nest);
  }

private:
  NodeId leaf(std::uint32_t slot, NodeTable &table) const {
    Leaf const &leaf = step_.leaves[slot];
    if (leaf.array == Array::values)
      return table.intern(
          Node::parameter(static_cast<std::uint32_t>(std::ranges::find(tables_, slot) - tables_.begin())));
    if (!is_angle(slot)) return table.intern(Node::input(slot));
    NodeId const angle = table.intern(Node::input(angle_.at(slot)));
    return table.intern(table.operation(leaf.array == Array::sine ? Op::sin : Op::cos, angle));
  }

  bool is_angle(std::uint32_t slot) const { return angle_.contains(slot); }
  // Whether the node is a sine or cosine computed at the start of the function.
  bool is_element(Graph const &graph, Node const &node) const {
    if (node.op != Op::sin && node.op != Op::cos) return false;
    Node const &angle = graph.nodes[node.operand[0]];
    return angle.op == Op::input && is_angle(angle.slot());
  }

  // Leaf of the angle itself, for passes that use it.
  Leaf input_of(std::uint32_t slot) const {
    std::vector<std::uint32_t> inputs;
    for (std::uint32_t k = 0; k < step_.count; ++k) inputs.push_back(angles_.inputs[step_.leaves[slot].access.at(k)]);
    return {Array::input, access_of(std::move(inputs))};
  }

  // Nodes that stores need, and loop-carried values with a reader. Marks the nodes that come from tables, and the
  // angles that are read themselves.
  std::vector<char> needed_nodes(Graph const &graph) {
    is_table_.assign(graph.nodes.size(), 0);
    is_read_.assign(graph.nodes.size(), 0);
    for (NodeId id : graph.precomputed) is_table_[id] = 1;
    for (NodeId id = 0; id < graph.nodes.size(); ++id)
      if (graph.nodes[id].op == Op::parameter) is_table_[id] = 1;
    std::vector<char> needed(graph.nodes.size(), 0);
    for (std::size_t k = 0; k < step_.stores.size(); ++k) needed[graph.results[k]] = 1;
    for (bool grows = true; grows;) {
      grows = false;
      for (NodeId id = static_cast<NodeId>(graph.nodes.size()); id-- > 0;) {
        Node const &node = graph.nodes[id];
        if (!needed[id] || is_table_[id] || is_leaf(node.op)) continue;
        for (unsigned i = 0; i < arity(node.op); ++i) {
          needed[node.operand[i]] = 1;
          if (!is_element(graph, node)) is_read_[node.operand[i]] = 1;
        }
      }
      std::size_t result = step_.stores.size();
      for (std::uint32_t k = 0; k < step_.leaves.size(); ++k) {
        if (!step_.leaves[k].is_carried) continue;
        NodeId const next = graph.results[result++];
        for (NodeId id = 0; id < graph.nodes.size(); ++id)
          if (needed[id] && !needed[next] && graph.nodes[id].op == Op::input && graph.nodes[id].slot() == k)
            needed[next] = 1, grows = true;
      }
    }
    return needed;
  }

  // Per table node, its value in each iteration.
  std::vector<std::vector<double>> table_rows(Graph const &graph, std::vector<char> const &needed) const {
    std::size_t count = 1; // of different rows
    for (std::uint32_t const k : tables_)
      count = step_.nest ? step_.count : std::lcm(count, step_.leaves[k].values.size());
    count = std::min<std::size_t>(count, step_.count);
    std::vector<std::vector<double>> columns(graph.nodes.size());
    std::vector<double> const inputs(graph.input_count(), 0.0);
    std::vector<double> parameters(tables_.size());
    for (std::size_t row = 0; row < count && !tables_.empty(); ++row) {
      for (std::size_t p = 0; p < tables_.size(); ++p) {
        parameters[p] = value_at(step_.leaves[tables_[p]], static_cast<std::uint32_t>(row), step_.nest);
      }
      std::vector<double> const values = evaluate(graph, inputs, parameters);
      for (NodeId id = 0; id < graph.nodes.size(); ++id)
        if (needed[id] && is_table_[id]) columns[id].push_back(values[id]);
    }
    for (std::vector<double> &column : columns)
      for (std::size_t k = column.size(); !column.empty() && k < step_.count; ++k) column.push_back(column[k % count]);
    return columns;
  }

  NodeId column(std::vector<std::vector<double>> const &columns, NodeId id, BodyBuilder &body) const {
    Role const role = role_of_values(columns[id], step_.nest);
    return role.constant ? body.constant(*role.constant) : body.leaf({role.array, {}, role.values, role.by_turn});
  }

  LoopStep const &step_;
  Angles const &angles_;
  std::vector<std::uint32_t> tables_;            // leaves
  std::map<std::uint32_t, std::uint32_t> angle_; // of a sine or cosine: the first leaf of the same angle
  std::vector<char> is_table_, is_read_;         // per node of the improved graph
};

// Searches each distinct body once: bodies may differ in their leaves alone, such as those of the inner loops of a
// nest.
Improve each_once(Improve const &improve) {
  using Key = std::pair<std::vector<std::uint64_t>, bool>;
  return [&improve, known = std::make_shared<std::map<Key, Graph>>()](Graph graph, bool in_loop) {
    Key key{{graph.input_count(), graph.parameter_count()}, in_loop};
    for (Node const &node : graph.nodes) {
      key.first.push_back(static_cast<std::uint64_t>(node.op));
      for (NodeId operand : node.operand) key.first.push_back(operand);
    }
    auto const add = [&](auto const &list) { key.first.insert(key.first.end(), list.begin(), list.end()); };
    add(graph.results);
    add(graph.node_exact);
    add(graph.node_location);
    auto const found = known->find(key);
    if (found != known->end()) return found->second;
    return known->emplace(std::move(key), improve(std::move(graph), in_loop)).first->second;
  };
}

} // namespace

std::size_t operations_of(Graph const &body) {
  std::vector<char> const live = live_nodes(body);
  std::size_t count = 0;
  for (NodeId id = 0; id < body.nodes.size(); ++id) count += live[id] && !is_leaf(body.nodes[id].op);
  return count;
}

std::size_t operations_of(LoopStep const &step) { return step.count * operations_of(step.body); }

LoopStep improved(LoopStep const &step, Angles const &angles, Improve const &improve) {
  Improver improver(step, angles);
  LoopStep cheaper = improver.step(improve(improver.graph(), step.count > 1));
  return operations_of(cheaper.body) < operations_of(step.body) ? cheaper : step;
}

void improve_bodies(LoopFunction &function, Angles const &angles, Improve const &improve) {
  Improve const once = each_once(improve);
  bool has_results = false;
  for (LoopStep &step : function.steps) {
    has_results = has_results || std::ranges::any_of(step.stores, &Store::is_result);
    LoopStep cheaper = improved(step, angles, once);
    // Passes may read an angle from the inputs, which results may overlap.
    if (!has_results || !reads_arguments(cheaper)) step = std::move(cheaper);
  }
  function = with_few_signs(std::move(function)); // passes have changed the tables
  for (LoopStep &step : function.steps) step = with_short_recurrences(std::move(step));
  function.operations = function.in_loops = 0;
  for (LoopStep const &step : function.steps) {
    std::size_t const operations = operations_of(step);
    function.operations += operations;
    if (step.count > 1) function.in_loops += operations;
  }
}

} // namespace symreal::reroll
