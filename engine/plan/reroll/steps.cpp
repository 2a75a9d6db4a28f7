#include "engine/plan/reroll/steps.h"

#include "engine/plan/reroll/body_builder.h"
#include "engine/plan/reroll/carried.h"

namespace symreal::reroll {

Step straight_step(Piece const &piece, Sequence const &sequence, Memory const &memory,
                   std::map<NodeId, std::vector<std::uint32_t>> const &results) {
  BodyBuilder body(*sequence.graph);
  std::map<NodeId, NodeId> now;
  auto const value = [&](NodeId node) {
    auto const [entry, is_new] = now.try_emplace(node, no_node);
    if (!is_new) return entry->second;
    Node const &there = sequence.graph->nodes[node];
    switch (sequence.source(node)) {
    case Source::computed: entry->second = body.leaf({Leaf::Kind::memory, {memory.home(node)}}); break;
    case Source::constant: entry->second = body.constant(there.value()); break;
    case Source::input:
    case Source::read:
    case Source::sine:
    case Source::cosine: {
      Leaf::Kind const array = array_of(sequence.source(node));
      entry->second = body.leaf({array, {sequence.element(node)}});
      break;
    }
    }
    return entry->second;
  };
  auto const store = [&](NodeId node, std::uint32_t element) { body.store(value(node), false, {element}); };
  for (std::uint32_t at = piece.begin; at < piece.end; ++at) {
    NodeId const id = sequence.operations[at].node;
    Node const &node = sequence.graph->nodes[id];
    std::array<NodeId, 3> operands = {no_node, no_node, no_node};
    for (unsigned i = 0; i < arity(node.op); ++i) operands[i] = value(node.operand[i]);
    now[id] = body.operation(node.op, operands, id);
    if (memory.has_home(id)) store(id, memory.home(id));
    if (auto const found = results.find(id); found != results.end())
      for (std::uint32_t const slot : found->second) body.store(now[id], true, {slot});
  }
  for (auto const &[cell, node] : piece.copies) store(node, memory.element(cell));
  for (NodeId node : piece.kept) store(node, memory.home(node));
  return body.finish(1);
}

Step loop_step(std::uint32_t loop, LoopBody const &plan, std::vector<Role> const &roles, Graph const &graph,
               Memory const &memory, std::vector<LoopResult> const &results) {
  BodyBuilder body(graph);
  std::vector<NodeId> leaves(plan.columns.size(), no_node), computed;
  Carried carried(body, memory);
  auto const column = [&](std::uint32_t number) {
    if (leaves[number] != no_node) return leaves[number];
    Role const &role = roles[number];
    if (role.constant)
      leaves[number] = body.constant(*role.constant);
    else
      leaves[number] = role.next != no_position ? carried.leaf(role.next, role.nodes)
                                                : body.leaf(leaf_of(role, memory, plan.repeat.rows));
    return leaves[number];
  };
  auto const value = [&](BodyOperand const &operand) {
    NodeId const number = operand.position != no_position ? computed[operand.position] : column(operand.column);
    if (operand.sign == no_column) return number;
    return body.operation(Op::mul, {column(operand.sign), number, no_node}, no_node);
  };
  for (BodyOperation const &operation : plan.operations) {
    std::array<NodeId, 3> operands = {no_node, no_node, no_node};
    for (unsigned i = 0; i < operation.count; ++i) operands[i] = value(operation.operands[i]);
    bool const first = operation.operands[0].negated, second = operation.operands[1].negated;
    internal_check(!(first && second));
    if (first) std::swap(operands[0], operands[1]);
    computed.push_back(body.operation(first || second ? Op::sub : operation.op, operands, operation.first));
  }
  carried.carry(computed);
  for (std::uint32_t const position : memory.stored_positions(loop))
    body.store(computed[position], false, memory.in_iterations(loop, position));
  for (auto const &[position, access] : memory.kept_positions(loop)) body.store(computed[position], false, access);
  for (LoopResult const &result : results) body.store(computed[result.position], true, result.access);
  return body.finish(plan.repeat.count, plan.repeat.rows);
}

} // namespace symreal::reroll
