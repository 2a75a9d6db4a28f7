// Functions whose statements are distributed over several threads.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

inline constexpr unsigned most_threads = 64;

// Calls `visit` with the variables that must precede a statement: its operands, the conditions of the blocks around it,
// and the preceding call if calls are ordered.
template <class IsVariable, class Visit> void for_each_before(Schedule const &plan, FunctionBody const &body,
                                                              std::size_t statement, IsVariable const &is_variable,
                                                              Visit const &visit);

// Whether a part reads a value that an earlier part of its stage computes. To find all conflicts, ask for every part.
bool waits_for_other_parts(Schedule const &plan, FunctionBody const &body, std::size_t part);

// Stage and thread that execute a statement of compute.
struct Share {
  std::uint32_t stage = 0, thread = 0;
};

// Sorts the statements of compute by stage and thread, stably. `shares`: per statement. No statement may
// precede its operands in that order.
Schedule shared_out(Schedule const &plan, std::vector<Share> const &shares, unsigned threads);

} // namespace symreal

#include "engine/plan/schedule/order.h"

namespace symreal {

template <class IsVariable, class Visit> void for_each_before(Schedule const &plan, FunctionBody const &body,
                                                              std::size_t statement, IsVariable const &is_variable,
                                                              Visit const &visit) {
  NodeId const id = body.variables[statement];
  auto const read = [&](NodeId use) {
    for_each_read(*plan.graph, use, is_variable, [&](NodeId other) { return is_read(plan, true, other); }, visit);
  };
  for (Literal const &literal : body.regions.literals(body.region[statement])) read(literal.condition);
  for_each_operand(plan, body, true, id, read);
  if (body.regions.is_gate(id)) return;
  Node const &node = plan.graph->nodes[id];
  if (node.op == Op::call_in_order && node.operand[2] != no_node && is_variable(node.operand[2]))
    visit(node.operand[2]);
}

} // namespace symreal
