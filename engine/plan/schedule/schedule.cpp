#include "engine/plan/schedule/schedule.h"

#include "engine/graph/graph.h"
#include "engine/plan/schedule/angles.h"
#include "engine/plan/schedule/dependences.h"
#include "engine/plan/schedule/order.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace symreal {

namespace {

// Limits of nesting: deeper expressions are hard to read, and compilers bound what they parse.
constexpr unsigned most_nested_operations = 12, most_nested_depth = 6;

struct Reach {
  std::vector<char> needed;
  std::vector<std::uint32_t> uses;
};

// Needed nodes and use counts. The walk stops at nodes that are read from `constants`.
Reach reach(Graph const &graph, std::vector<NodeId> const &roots, std::vector<std::uint32_t> const *constant_slot) {
  Reach result{std::vector<char>(graph.nodes.size(), 0), std::vector<std::uint32_t>(graph.nodes.size(), 0)};
  for (NodeId root : roots) {
    result.needed[root] = 1;
    ++result.uses[root];
  }
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!result.needed[id] || is_leaf(node.op)) continue;
    if (constant_slot && (*constant_slot)[id] != no_slot) continue;
    for (NodeId operand : node.operand) {
      if (operand == no_node) continue;
      result.needed[operand] = 1;
      // The operands of an argument list are printed at every use of the list.
      result.uses[operand] += node.op == Op::argument ? result.uses[id] : 1;
    }
  }
  return result;
}

class Layout {
public:
  Layout(FunctionKind kind, Graph const &graph, std::vector<NodeId> const &results,
         std::vector<NodeId> const &conditions, NodeId effect, std::vector<std::uint32_t> const *constant_slot,
         Nesting nesting, Arms arms)
      : kind_(kind),
        graph_(graph),
        nesting_(nesting),
        arms_(arms),
        results_(results),
        conditions_(conditions),
        effect_(effect),
        needs_(reach(graph, roots(), constant_slot)),
        is_read_(graph.nodes.size(), 0),
        has_variable_(graph.nodes.size(), 0) {
    for (std::size_t id = 0; id < graph.nodes.size(); ++id)
      is_read_[id] = is_leaf(graph.nodes[id].op) || is_literal(graph.nodes[id]) ||
                     (constant_slot && (*constant_slot)[id] != no_slot);
    // Arrays may overlap, so all inputs are read before an output is written: an output needs a variable, or the array
    // of a call.
    for (NodeId result : results)
      if (!graph.nodes[result].is_constant() && graph.nodes[result].op != Op::returned) has_variable_[result] = 1;
    // gcc 12 misfolds 0.0 - fabs(x) to -fabs(x), which is -0 where the difference is +0, if one expression has both.
    for (Node const &node : graph.nodes)
      if (node.op == Op::sub && is_zero(graph.nodes[node.operand[0]]) && !is_read_[node.operand[1]])
        has_variable_[node.operand[1]] = 1;
  }

  PlanFunction run() {
    Placement placement = arms_ == Arms::in_blocks ? place(graph_, roots(), needs_.needed, is_read_)
                                                   : Placement{Regions(graph_.nodes.size()), {}};
    std::vector<NodeId> variables = choose_variables();
    if (placement.conditional()) {
      give_variables_to_conditions(placement, variables);
      variables = choose_variables();
    }
    PlanFunction body{kind_, std::move(variables), {}, {}, {}, results_, wanted_returns()};
    order(graph_, is_read_, placement, body);
    body.regions = tabulate(placement.regions, graph_.nodes.size(), body.region);
    if (body.variables.size() > usual_part_length) delay(graph_, is_read_, conditions_, body);
    schedule_for_registers(graph_, is_read_, body);
    place_checks(body);
    return body;
  }

private:
  std::vector<NodeId> roots() const {
    std::vector<NodeId> roots = results_;
    roots.insert(roots.end(), conditions_.begin(), conditions_.end());
    if (effect_ != no_node) roots.push_back(effect_);
    return roots;
  }

  static bool is_zero(Node const &node) { return node.is_constant() && node.value() == 0; }

  // Whether the node is a constant 64-bit integer.
  bool is_literal(Node const &node) const { return node.op == Op::wide && node.attribute == Attribute::constant; }

  // Nodes that are used more than once, are too large to nest, or already have a variable.
  std::vector<NodeId> choose_variables() const {
    std::vector<std::uint8_t> operations(graph_.nodes.size(), 0), depth(graph_.nodes.size(), 0); // of nested ones
    std::vector<NodeId> variables;
    for (std::size_t id = 0; id < graph_.nodes.size(); ++id) {
      if (!needs_.needed[id]) continue;
      Op const op = graph_.nodes[id].op;
      // A call is a statement; its argument list is part of it, and its results are in an array.
      bool const in_array = op == Op::returned && !is_read_[id] && !has_variable_[id] && nesting_ == Nesting::bounded;
      if (op == Op::argument || in_array) continue;
      unsigned size = 1, height = 0;
      if (!is_read_[id])
        for (NodeId operand : graph_.nodes[id].operand) {
          if (operand == no_node) continue;
          size += operations[operand];
          height = std::max<unsigned>(height, depth[operand]);
        }
      bool const fits = is_read_[id] || (nesting_ == Nesting::bounded && needs_.uses[id] == 1 &&
                                         size <= most_nested_operations && height < most_nested_depth);
      if (!fits || has_variable_[id] || is_call(op)) {
        variables.push_back(static_cast<NodeId>(id));
      } else if (!is_read_[id]) {
        operations[id] = static_cast<std::uint8_t>(size);
        depth[id] = static_cast<std::uint8_t>(height + 1);
      }
    }
    return variables;
  }

  std::set<NodeId> wanted_returns() const {
    std::set<NodeId> calls;
    for (std::size_t id = 0; id < graph_.nodes.size(); ++id) {
      Node const &node = graph_.nodes[id];
      if (!needs_.needed[id] || is_read_[id] || node.op != Op::returned) continue;
      External const &external = graph_.externals[function_of(graph_, graph_.nodes[node.operand[0]])];
      if (result_of(graph_, node) < external.returned_count()) calls.insert(node.operand[0]);
    }
    return calls;
  }

  // Assigns variables to conditions, which are computed before their blocks.
  void give_variables_to_conditions(Placement const &placement, std::vector<NodeId> const &variables) {
    Regions const &regions = placement.regions;
    std::vector<RegionId> regions_to_see;
    std::vector<char> seen;
    auto see = [&](RegionId region) {
      if (region >= seen.size()) seen.resize(region + std::size_t{1}, 0);
      if (!std::exchange(seen[region], 1)) regions_to_see.push_back(region);
    };
    for (NodeId id : variables) see(placement.of_node[id]);
    while (!regions_to_see.empty()) {
      RegionId const region = regions_to_see.back();
      regions_to_see.pop_back();
      for (Literal const &literal : regions.literals(region)) {
        if (regions.is_gate(literal.condition)) {
          see(regions.of_gate(literal.condition));
          for (RegionId alternative : regions.alternatives(literal.condition)) see(alternative);
        } else {
          if (!is_read_[literal.condition]) has_variable_[literal.condition] = 1;
          see(placement.of_node[literal.condition]);
        }
      }
    }
  }

  void place_checks(PlanFunction &body) const {
    std::vector<std::size_t> after(body.regions.value_count(), 0); // per variable: its statement, from 1
    for (std::size_t k = 0; k < body.variables.size(); ++k) after[body.variables[k]] = k + 1;
    std::size_t before = 0;
    for (NodeId condition : conditions_) {
      for_each_read(
          graph_, condition, [&](NodeId id) { return after[id] != 0; }, [&](NodeId id) { return is_read_[id] != 0; },
          [&](NodeId id) { before = std::max(before, after[id]); });
      body.checks.push_back({condition, before});
    }
  }

  FunctionKind kind_;
  Graph const &graph_;
  Nesting nesting_;
  Arms arms_;
  std::vector<NodeId> const &results_, &conditions_;
  NodeId effect_;
  Reach const needs_;
  std::vector<char> is_read_, has_variable_;
};

} // namespace

std::vector<std::uint32_t> constant_slots(Graph const &graph, std::vector<NodeId> const &stored) {
  std::vector<std::uint32_t> slots(graph.nodes.size(), no_slot);
  for (std::size_t slot = 0; slot < stored.size(); ++slot) slots[stored[slot]] = static_cast<std::uint32_t>(slot);
  return slots;
}

Plan schedule(Graph const &graph, Nesting nesting, Arms arms) {
  std::vector<NodeId> stored = graph.precomputed, conditions, roots = graph.results;
  std::vector<std::uint32_t> constant_slot = constant_slots(graph, stored);
  for (Guard const &guard : graph.guards) conditions.push_back(guard.condition);
  roots.insert(roots.end(), conditions.begin(), conditions.end());
  if (graph.last_effect != no_node) roots.push_back(graph.last_effect);
  // Without pass preprocess, compute still has no parameters: those that it needs go through `constants`.
  Reach const needs = reach(graph, roots, &constant_slot);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (needs.needed[id] && graph.nodes[id].op == Op::parameter && constant_slot[id] == no_slot) {
      constant_slot[id] = static_cast<std::uint32_t>(stored.size());
      stored.push_back(static_cast<NodeId>(id));
    }
  using enum FunctionKind;
  Plan plan{&graph, {}, std::move(constant_slot), stored.size(), nesting};
  plan.functions.push_back(Layout(preprocess, graph, stored, {}, no_node, nullptr, nesting, arms).run());
  plan.functions.push_back(
      Layout(compute, graph, graph.results, conditions, graph.last_effect, &plan.constant_slot, nesting, arms).run());
  return plan;
}

PlanFunction lay_out(FunctionKind kind, std::vector<NodeId> const &results, Plan const &plan) {
  return Layout(kind, *plan.graph, results, {}, no_node, &plan.constant_slot, plan.nesting, Arms::computed).run();
}

Plan shared_out(Plan const &plan, std::vector<Share> const &shares, unsigned threads) {
  PlanFunction const &body = plan.compute();
  std::vector<std::size_t> order(body.variables.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto const key = [&](std::size_t k) { return std::pair(shares[k].stage, shares[k].thread); };
  std::ranges::stable_sort(order, {}, key);
  Plan result = plan;
  result.threads = threads;
  PlanFunction &sorted = result.compute();
  for (std::size_t at = 0; at < order.size(); ++at) {
    sorted.variables[at] = body.variables[order[at]];
    sorted.region[at] = body.region[order[at]];
    std::vector<ThreadPart> &parts = sorted.parts;
    if (at == 0 || key(order[at - 1]) != key(order[at])) {
      bool const same_stage = at != 0 && shares[order[at - 1]].stage == shares[order[at]].stage;
      parts.push_back({parts.empty() ? 0 : parts.back().stage + (same_stage ? 0U : 1U), at});
    }
    parts.back().end = at + 1;
  }
  for (Check &check : sorted.checks) check.before = order.size();
  return result;
}

Plan in_form(Plan plan, PlanForm const &form) {
  bool const has_angles = plan.angles.size() != 0;
  bool const needs_blocks = has_angles || plan.has_loops() || plan.vectors() || plan.threads > 1;
  if (form.has_angles && !has_angles) return with_angles(std::move(plan));
  if (form.has_blocks || needs_blocks) return plan;
  return schedule(*plan.graph, Nesting::bounded, Arms::computed);
}

} // namespace symreal
