#include "engine/plan/reroll/plan.h"

#include "engine/plan/reroll/copies.h"
#include "engine/plan/reroll/direct_results.h"
#include "engine/plan/reroll/memory.h"
#include "engine/plan/reroll/mirrors.h"
#include "engine/plan/reroll/pieces.h"
#include "engine/plan/reroll/row_roles.h"
#include "engine/plan/reroll/steps.h"

#include <algorithm>
#include <set>

namespace symreal::reroll {

namespace {

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
      Step step = piece.loop == no_position ? straight_step(piece, sequence_, memory_, direct_.of_operation)
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
      std::optional<Role> role = loops_[loop].repeat.rows ? choose_role_in_rows(sequence_, loops_, loop, column,
                                                                                memory_, copy, entries_.back())
                                                          : choose_role(sequence_, loops_, loop, column, memory_, copy);
      if (!role) return false;
      roles_.back().push_back(std::move(*role));
    }
    return true;
  }

  // Stores the initial values of chains before their rows.
  void enter_chains(std::uint32_t loop, std::vector<Step> &steps) const {
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
        return role.kind == Leaf::Kind::carried || (role.cell && role.cell->loop == loop) ||
               std::ranges::any_of(role.nodes, is_own);
      }));
    }
    return result;
  }

  // Keeps inputs among the results and guards in memory, for the result copies and the checks.
  void need_inputs_among_results() {
    std::set<NodeId> kept;
    for (auto const *roots : {&stored_, &checked_})
      for (NodeId root : *roots) {
        Source const source = sequence_.source(root);
        bool const is_number = source == Source::constant && roots == &stored_;
        if (source != Source::computed && !is_number && kept.insert(root).second) pieces_.back().kept.push_back(root);
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
      if (!direct_.is_stored[k] && sequence_.source(stored_[k]) != Source::constant)
        memory_.need_kept(stored_[k], copied);
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
