#include "schedule/angles.h"

#include "schedule/order.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

namespace {

bool is_exact(Graph const &graph, NodeId id) { return !graph.node_exact.empty() && graph.node_exact[id]; }

// Per node: whether it is the sine or cosine of an input and is computed in any case.
std::vector<char> candidates(Schedule const &plan) {
  Graph const &graph = *plan.graph;
  std::vector<char> const live = live_nodes(graph);
  std::vector<char> result(graph.nodes.size(), 0);
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    bool const is_one = node.op == Op::sin || node.op == Op::cos;
    result[id] = is_one && live[id] && graph.nodes[node.operand[0]].op == Op::input && !is_exact(graph, id);
  }
  FunctionBody const &body = plan.compute;
  std::vector<char> is_variable(body.regions.value_count(), 0);
  for (NodeId id : body.variables) is_variable[id] = 1;
  for (std::size_t k = 0; k < body.variables.size(); ++k) {
    if (body.region[k] == everywhere || body.regions.is_gate(body.variables[k])) continue;
    SmallStack<NodeId> nested;
    for (nested.push(body.variables[k]); !nested.empty();) {
      NodeId const id = nested.pop();
      result[id] = 0;
      if (is_read(plan, true, id)) continue;
      for (NodeId operand : graph.nodes[id].operand)
        if (operand != no_node && !is_variable[operand]) nested.push(operand);
    }
  }
  return result;
}

Angles angles_of(Graph const &graph, std::vector<char> const &wanted) {
  Angles angles;
  for (NodeId id = 0; id < graph.nodes.size(); ++id)
    if (wanted[id]) angles.inputs.push_back(graph.nodes[graph.nodes[id].operand[0]].slot());
  std::ranges::sort(angles.inputs);
  auto const same = std::ranges::unique(angles.inputs);
  angles.inputs.erase(same.begin(), same.end());
  if (angles.inputs.empty()) return angles;
  angles.element.assign(graph.nodes.size(), no_slot);
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    if (!wanted[id]) continue;
    std::uint32_t const input = graph.nodes[graph.nodes[id].operand[0]].slot();
    angles.element[id] =
        static_cast<std::uint32_t>(std::ranges::lower_bound(angles.inputs, input) - angles.inputs.begin());
  }
  return angles;
}

// The statements that are left: checks and parts stand where they stood.
void leave_out(std::vector<std::uint32_t> const &element, FunctionBody &body) {
  std::vector<std::size_t> left(body.variables.size() + 1, 0); // of the statements before each
  std::size_t count = 0;
  for (std::size_t k = 0; k < body.variables.size(); ++k) {
    NodeId const id = body.variables[k];
    if (body.regions.is_gate(id) || element[id] == no_slot) {
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

} // namespace

Schedule with_angles(Schedule plan) {
  plan.angles = angles_of(*plan.graph, candidates(plan));
  if (!plan.angles.inputs.empty()) leave_out(plan.angles.element, plan.compute);
  return plan;
}

std::string describe(Angles const &angles) {
  if (angles.inputs.empty()) return {};
  return fmt::format("compute: sine and cosine of {} input{} side by side", angles.inputs.size(),
                     angles.inputs.size() == 1 ? "" : "s");
}

} // namespace symreal
