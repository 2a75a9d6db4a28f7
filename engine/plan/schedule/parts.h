// Functions whose statements several threads share.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

inline constexpr unsigned most_threads = 64;

// Calls `visit` with the variables that must be set before a statement begins: those that it reads, the conditions of
// the blocks around it, and the call before it where calls have an order.
template <class IsVariable, class Visit> void for_each_before(Schedule const &plan, FunctionBody const &body,
                                                              std::size_t statement, IsVariable const &is_variable,
                                                              Visit const &visit);

// Whether a part reads what another part of its stage computes. All parts before it have been asked.
bool waits_for_other_parts(Schedule const &plan, FunctionBody const &body, std::size_t part);

// What a thread does of compute, and when.
struct Share {
  std::uint32_t stage = 0, thread = 0;
};

// The statements of compute in the order of their stages and threads, otherwise as they were. `shares`: per statement.
// Nothing stands before what it needs.
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
