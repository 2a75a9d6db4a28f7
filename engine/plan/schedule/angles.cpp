#include "engine/plan/schedule/angles.h"

#include "engine/plan/schedule/dependences.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

namespace {

bool is_exact(Graph const &graph, NodeId id) { return !graph.node_exact.empty() && graph.node_exact[id]; }

// Per node: whether it is a sine or cosine that is computed unconditionally.
std::vector<char> candidates(Plan const &plan) {
  Graph const &graph = *plan.graph;
  std::vector<char> const live = live_nodes(graph);
  std::vector<char> result(graph.nodes.size(), 0);
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    bool const is_one = node.op == Op::sin || node.op == Op::cos;
    result[id] = is_one && live[id] && plan.constant_slot[id] == no_slot && !is_exact(graph, id);
  }
  PlanFunction const &body = plan.compute();
  std::vector<char> is_variable(body.regions.value_count(), 0);
  for (NodeId id : body.variables) is_variable[id] = 1;
  for (std::size_t k = 0; k < body.variables.size(); ++k) {
    if (body.region[k] == everywhere || body.regions.is_gate(body.variables[k])) continue;
    SmallStack<NodeId> nested;
    for (nested.push(body.variables[k]); !nested.empty();) {
      NodeId const id = nested.pop();
      result[id] = 0;
      if (is_read(plan, FunctionKind::compute, id)) continue;
      for (NodeId operand : graph.nodes[id].operand)
        if (operand != no_node && !is_variable[operand]) nested.push(operand);
    }
  }
  return result;
}

// Angles of the wanted nodes: those that are inputs, or else the computed ones.
std::vector<NodeId> angles_of(Graph const &graph, std::vector<char> const &wanted, bool are_inputs) {
  std::vector<NodeId> angles;
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (NodeId const angle = graph.nodes[id].operand[0];
        wanted[id] && (graph.nodes[angle].op == Op::input) == are_inputs)
      angles.push_back(angle);
  if (are_inputs)
    std::ranges::sort(angles, {}, [&](NodeId id) { return graph.nodes[id].slot(); });
  else
    std::ranges::sort(angles);
  auto const same = std::ranges::unique(angles);
  angles.erase(same.begin(), same.end());
  return angles;
}

// Assigns these angles the elements from `next` on.
void give_elements(Graph const &graph, std::vector<char> const &wanted, std::vector<NodeId> const &angles,
                   std::size_t next, std::vector<std::uint32_t> &element) {
  if (angles.empty()) return;
  std::vector<std::uint32_t> of_angle(graph.nodes.size(), no_slot);
  for (NodeId const angle : angles) of_angle[angle] = static_cast<std::uint32_t>(next++);
  element.resize(graph.nodes.size(), no_slot);
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (wanted[id] && of_angle[graph.nodes[id].operand[0]] != no_slot)
      element[id] = of_angle[graph.nodes[id].operand[0]];
}

// Per node: whether it can be computed before all sines, by operations that may be repeated.
std::vector<char> comes_first(Plan const &plan) {
  Graph const &graph = *plan.graph;
  std::vector<char> result(graph.nodes.size(), 0);
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    bool const is_sum_or_product = node.op == Op::add || node.op == Op::sub || node.op == Op::mul || node.op == Op::neg;
    bool const is_found = is_leaf(node.op) || plan.constant_slot[id] != no_slot;
    result[id] = is_found || is_sum_or_product;
    for (unsigned i = 0; i < arity(node.op) && !is_found; ++i) result[id] = result[id] && result[node.operand[i]];
  }
  return result;
}

std::vector<NodeId> roots_of_compute(Graph const &graph) {
  std::vector<NodeId> roots = graph.results;
  for (Guard const &guard : graph.guards) roots.push_back(guard.condition);
  if (graph.last_effect != no_node) roots.push_back(graph.last_effect);
  return roots;
}

// Removes the other statements; checks and parts keep their places.
template <class IsLeft> void leave_out(IsLeft const &is_left, PlanFunction &body) {
  std::vector<std::size_t> left(body.variables.size() + 1, 0); // per statement: remaining statements before it
  std::size_t count = 0;
  for (std::size_t k = 0; k < body.variables.size(); ++k) {
    NodeId const id = body.variables[k];
    if (body.regions.is_gate(id) || is_left(id)) {
      body.variables[count] = id;
      body.region[count++] = body.region[k];
    }
    left[k + 1] = count;
  }
  body.variables.resize(count);
  body.region.resize(count);
  for (Check &check : body.checks) check.before = left[check.before];
  for (ThreadPart &part : body.parts) part.end = left[part.end];
}

// Least number of computed angles: one vector of doubles; below that, a loop does not pay.
constexpr std::size_t least_computed = 4;

void add_computed(std::vector<char> wanted, Plan &plan) {
  Graph const &graph = *plan.graph;
  if (!is_straight(graph, plan.compute()) || !plan.compute().parts.empty()) return;
  std::vector<char> const is_first = comes_first(plan);
  for (NodeId id = 0; id < graph.nodes.size(); ++id) wanted[id] = wanted[id] && is_first[graph.nodes[id].operand[0]];
  std::vector<NodeId> const computed = angles_of(graph, wanted, false);
  if (computed.size() < least_computed) return;
  std::vector<char> const before = needed_operations(plan, FunctionKind::compute, computed);
  Angles const without = plan.angles;
  give_elements(graph, wanted, computed, plan.angles.inputs.size(), plan.angles.element);
  std::vector<char> const behind = needed_operations(plan, FunctionKind::compute, roots_of_compute(graph));
  std::size_t twice = 0;
  for (NodeId id = 0; id < graph.nodes.size(); ++id) twice += before[id] && behind[id];
  if (2 * twice > computed.size()) {
    plan.angles = without;
    return;
  }
  plan.make(FunctionKind::angles) = lay_out(FunctionKind::angles, computed, plan);
  plan.angles.computed = computed.size();
  leave_out(
      [&](NodeId id) {
        return plan.angles.element[id] == no_slot && (behind[id] || is_read(plan, FunctionKind::compute, id));
      },
      plan.compute());
}

} // namespace

Plan with_angles(Plan plan) {
  Graph const &graph = *plan.graph;
  std::vector<char> const wanted = candidates(plan);
  std::vector<NodeId> const inputs = angles_of(graph, wanted, true);
  for (NodeId const input : inputs) plan.angles.inputs.push_back(graph.nodes[input].slot());
  give_elements(graph, wanted, inputs, 0, plan.angles.element);
  if (!inputs.empty()) leave_out([&](NodeId id) { return plan.angles.element[id] == no_slot; }, plan.compute());
  add_computed(wanted, plan);
  return plan;
}

std::string describe(Angles const &angles) {
  auto const counted = [](std::size_t count, char const *what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text;
  if (!angles.inputs.empty()) text = counted(angles.inputs.size(), "input");
  if (angles.computed != 0) text += (text.empty() ? "" : " and ") + counted(angles.computed, "computed angle");
  return text.empty() ? text : fmt::format("compute: sine and cosine of {} side by side", text);
}

} // namespace symreal
