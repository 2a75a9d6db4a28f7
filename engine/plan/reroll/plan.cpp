#include "engine/plan/reroll/plan.h"

#include "engine/plan/reroll/results.h"
#include "engine/plan/reroll/roles.h"

#include <algorithm>
#include <map>
#include <ranges>
#include <set>
#include <utility>

namespace symreal::reroll {

namespace {

// A loop, or a piece of straight-line code.
struct Piece {
  std::uint32_t begin, end;
  std::uint32_t loop = no_position;
  std::vector<std::pair<Cell, NodeId>> copies = {}; // read by later loops
  std::vector<NodeId> kept = {};                    // nodes without an operation that are read from memory

  bool computes(Sequence const &sequence, NodeId node) const {
    return sequence.position[node] != no_position && sequence.position[node] >= begin && sequence.position[node] < end;
  }
};

constexpr std::uint32_t most_operations = 1000; // of a straight piece: compilation time is superlinear in function size

// Pieces in order, with at least one straight piece before each loop and at the end.
std::vector<Piece> pieces(Sequence const &sequence, std::vector<LoopBody> const &loops) {
  std::vector<Piece> pieces;
  std::uint32_t at = 0;
  auto const straight_to = [&](std::uint32_t end) {
    do {
      std::uint32_t const next = std::min(at + most_operations, end);
      pieces.push_back({at, next});
      at = next;
    } while (at < end);
  };
  for (std::uint32_t loop = 0; loop < loops.size(); ++loop) {
    Repeat const &repeat = loops[loop].repeat;
    straight_to(repeat.begin);
    pieces.push_back({repeat.begin, repeat.end(), loop});
    at = repeat.end();
  }
  straight_to(static_cast<std::uint32_t>(sequence.size()));
  return pieces;
}

// Whether the piece reads arrays that results may overlap. `roles`: per loop and column.
bool reads_arguments(Piece const &piece, Sequence const &sequence, std::vector<std::vector<Role>> const &roles) {
  if (piece.loop != no_position) return std::ranges::any_of(roles[piece.loop], is_argument, &Role::array);
  auto const is_given = [&](NodeId node) { return is_argument(sequence.array(node)); };
  for (std::uint32_t at = piece.begin; at < piece.end; ++at)
    for (unsigned i = 0; i < sequence.operations[at].count; ++i)
      if (is_given(sequence.operations[at].operands[i].node)) return true;
  return std::ranges::any_of(piece.copies | std::views::values, is_given) || std::ranges::any_of(piece.kept, is_given);
}

// `results`: per operation the results that the step stores directly.
LoopStep straight_step(Piece const &piece, Sequence const &sequence, Memory const &memory,
                       std::map<NodeId, std::vector<std::uint32_t>> const &results) {
  BodyBuilder body(*sequence.graph);
  std::map<NodeId, NodeId> now;
  auto const value = [&](NodeId node) {
    auto const [entry, is_new] = now.try_emplace(node, no_node);
    if (!is_new) return entry->second;
    Node const &there = sequence.graph->nodes[node];
    switch (Array const array = sequence.array(node)) {
    case Array::memory: entry->second = body.leaf({array, {memory.home(node)}}); break;
    case Array::values: entry->second = body.constant(there.value()); break;
    default: entry->second = body.leaf({array, {sequence.element(node)}});
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

// Loop-carried values of a body: a value that is read several iterations later moves from variable to variable.
class Carried {
public:
  Carried(BodyBuilder &body, Memory const &memory) : body_(body), memory_(memory) {}

  // Leaf for the value of body operation `next`; `first`: its values in the first iterations.
  NodeId leaf(std::uint32_t next, std::vector<NodeId> first) {
    auto const [entry, is_new] = leaves_.try_emplace({next, first}, no_node);
    if (!is_new) return entry->second;
    Leaf leaf{.array = Array::memory, .access = {memory_.home(first.front())}, .is_carried = true};
    first.erase(first.begin());
    if (!first.empty()) leaf.next = this->leaf(next, std::move(first));
    return entry->second = body_.leaf(std::move(leaf));
  }

  // Completes the leaves once the body's operations exist.
  void carry(std::vector<NodeId> const &computed) {
    for (auto const &[key, leaf] : leaves_)
      if (key.second.size() == 1) body_.carry(leaf, computed[key.first]);
  }

private:
  BodyBuilder &body_;
  Memory const &memory_;
  std::map<std::pair<std::uint32_t, std::vector<NodeId>>, NodeId> leaves_;
};

// `loop`: its number in memory. `roles`: of its columns. `results`: those that the loop stores directly.
LoopStep loop_step(std::uint32_t loop, LoopBody const &plan, std::vector<Role> const &roles, Graph const &graph,
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

class Planner {
public:
  Planner(Sequence sequence, std::vector<Repeat> const &repeats, std::vector<NodeId> const &stored,
          std::vector<NodeId> const &checked, std::vector<Object> const &objects)
      : sequence_(std::move(sequence)),
        stored_(stored),
        checked_(checked),
        objects_(objects),
        loops_(bodies(repeats)),
        pieces_(pieces(sequence_, loops_)),
        memory_(sequence_, loops_, piece_of_operations()) {}

  std::optional<LoopFunction> run() {
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      if (pieces_[k].loop == no_position)
        need_operands(k);
      else if (!choose_roles(k))
        return {};
    }
    need_inputs_among_results();
    LoopFunction function;
    function.mirrors = mirrors(objects_, stored_, memory_);
    direct_ = direct_results(sequence_, loops_, stored_, function.mirrors, memory_, first_to_store_results());
    need_roots();
    if (memory_.is_overwritten_early()) return {};
    memory_.lay_out(independent_loops());
    for (Piece const &piece : pieces_) {
      if (piece.loop != no_position) enter_chains(piece.loop, function.steps);
      LoopStep step = piece.loop == no_position ? straight_step(piece, sequence_, memory_, direct_.of_operation)
                                                : loop_step(piece.loop, loops_[piece.loop], roles_[piece.loop],
                                                            *sequence_.graph, memory_, direct_.of_loop[piece.loop]);
      if (!step.stores.empty()) function.steps.push_back(std::move(step));
    }
    add_result_copies(*sequence_.graph, stored_, direct_.is_stored, memory_, function.steps);
    for (NodeId condition : checked_) function.checks.push_back(memory_.home(condition));
    function.memory = memory_.size();
    function.operations = sequence_.size();
    function.loops = loops_.size();
    for (LoopBody const &loop : loops_) function.in_loops += std::size_t{loop.repeat.period} * loop.repeat.count;
    return function;
  }

private:
  std::vector<LoopBody> bodies(std::vector<Repeat> const &repeats) {
    std::vector<std::uint32_t> uses(sequence_.graph->nodes.size(), 0);
    for (Operation const &operation : sequence_.operations)
      for (unsigned i = 0; i < operation.count; ++i) ++uses[operation.operands[i].node];
    for (auto const *roots : {&stored_, &checked_})
      for (NodeId root : *roots) ++uses[root];
    std::vector<LoopBody> result;
    for (Repeat const &repeat : repeats) result.push_back(loop_body(sequence_, repeat, uses));
    return result;
  }

  std::vector<std::uint32_t> piece_of_operations() const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) result.resize(pieces_[k].end, k);
    return result;
  }

  void need_operands(std::uint32_t number) {
    Piece const &piece = pieces_[number];
    for (std::uint32_t at = piece.begin; at < piece.end; ++at)
      for (unsigned i = 0; i < sequence_.operations[at].count; ++i) {
        NodeId const node = sequence_.operations[at].operands[i].node;
        if (sequence_.is_computed(node) && !piece.computes(sequence_, node)) memory_.need(node, number);
      }
  }

  // Chooses a role for each operand of the loop; false if an operand has no role.
  bool choose_roles(std::uint32_t number) {
    std::uint32_t const loop = pieces_[number].loop;
    Piece &before = pieces_[number - 1];
    auto const copy = [&](Cell const &cell, NodeId node) {
      if (!memory_.hold_copy(cell, node, number)) return;
      before.copies.emplace_back(cell, node);
      if (!before.computes(sequence_, node)) memory_.need(node, number - 1);
    };
    roles_.emplace_back();
    entries_.emplace_back();
    for (Column const &column : loops_[loop].columns) {
      std::optional<Role> role = choose_role(sequence_, loops_, loop, column, memory_, copy, entries_.back());
      if (!role) return false;
      roles_.back().push_back(std::move(*role));
    }
    return true;
  }

  // Stores the initial values of chains before their rows.
  void enter_chains(std::uint32_t loop, std::vector<LoopStep> &steps) const {
    Copies copies{{}, {}, false};
    for (auto const &[position, nodes] : entries_[loop])
      for (std::uint32_t chain = 0; chain < nodes.size(); ++chain) {
        copies.nodes.push_back(nodes[chain]);
        copies.places.push_back(memory_.element({loop, position, 0}) + chain);
      }
    add_copies(*sequence_.graph, copies, memory_, steps);
  }

  // Per loop whether its iterations are independent.
  std::vector<char> independent_loops() const {
    std::vector<char> result;
    for (std::uint32_t loop = 0; loop < loops_.size(); ++loop) {
      auto const is_own = [&](NodeId node) {
        std::optional<Cell> const cell = memory_.cell(node);
        return cell && cell->loop == loop;
      };
      result.push_back(std::ranges::none_of(roles_[loop], [&](Role const &role) {
        return role.is_carried || (role.cell && role.cell->loop == loop) || std::ranges::any_of(role.nodes, is_own);
      }));
    }
    return result;
  }

  // Keeps inputs among the results and guards in memory, for the result copies and the checks.
  void need_inputs_among_results() {
    std::set<NodeId> kept;
    for (auto const *roots : {&stored_, &checked_})
      for (NodeId root : *roots) {
        Array const source = sequence_.array(root);
        bool const is_number = source == Array::values && roots == &stored_;
        if (source != Array::memory && !is_number && kept.insert(root).second) pieces_.back().kept.push_back(root);
      }
  }

  // First operation that may store results: behind the last read of an input, in a function without guards.
  std::size_t first_to_store_results() const {
    if (!checked_.empty()) return sequence_.size();
    std::size_t piece = pieces_.size();
    while (piece > 0 && !reads_arguments(pieces_[piece - 1], sequence_, roles_)) --piece;
    return piece == pieces_.size() ? sequence_.size() : pieces_[piece].begin;
  }

  void need_roots() {
    auto const copied = static_cast<std::uint32_t>(pieces_.size()); // by the steps behind all pieces
    for (std::size_t k = 0; k < stored_.size(); ++k)
      if (!direct_.is_stored[k] && sequence_.array(stored_[k]) != Array::values) memory_.need_kept(stored_[k], copied);
    for (NodeId root : checked_) memory_.need_kept(root, copied);
  }

  Sequence sequence_;
  std::vector<NodeId> const &stored_, &checked_;
  std::vector<Object> const &objects_;
  std::vector<LoopBody> loops_;
  std::vector<Piece> pieces_;
  Memory memory_;
  std::vector<std::vector<Role>> roles_;    // per loop and column
  std::vector<std::vector<Entry>> entries_; // per loop
  DirectResults direct_;
};

} // namespace

std::optional<LoopFunction> plan(Sequence sequence, std::vector<Repeat> const &repeats,
                                 std::vector<NodeId> const &stored, std::vector<NodeId> const &checked,
                                 std::vector<Object> const &objects) {
  return Planner(std::move(sequence), repeats, stored, checked, objects).run();
}

} // namespace symreal::reroll
