#include "engine/plan/reroll/row_roles.h"

#include "engine/plan/reroll/nest.h"

namespace symreal::reroll {

namespace {

// Operation that computes the operand in the row before, with each chain's initial value; nullopt if it varies.
std::optional<Entry> entry_of(std::vector<NodeId> const &nodes, Nest const &rows, std::uint32_t loop,
                              Sequence const &sequence, std::vector<LoopBody> const &loops, Memory const &memory) {
  std::optional<Cell> const second = memory.cell(nodes[static_cast<std::size_t>(begin_of(rows, 1))]);
  if (!second || second->loop != loop) return {};
  Entry entry{second->position, {}};
  for (std::uint32_t k = 0; k < nodes.size(); ++k) {
    auto const [row, chain] = turn_of(rows, k);
    if (row > 0 && chain < length_of(rows, row - 1)) {
      if (memory.cell(nodes[k]) != Cell{loop, entry.position, begin_of(rows, row - 1) + chain}) return {};
    } else {
      std::uint32_t const made = sequence.position[nodes[k]];
      if (made == no_position || made >= loops[loop].repeat.begin) return {};
      entry.nodes.push_back(nodes[k]);
    }
  }
  return entry;
}

} // namespace

std::optional<Role> choose_role_in_rows(Sequence const &sequence, std::vector<LoopBody> const &loops,
                                        std::uint32_t loop, Column const &column, Memory &memory,
                                        std::function<void(Cell const &, NodeId)> const &copy,
                                        std::vector<Entry> &entries) {
  std::optional<Nest> const &of_loop = loops[loop].repeat.rows;
  internal_check(of_loop.has_value());
  Nest const &rows = *of_loop;
  // Signs may still differ from chain to chain here.
  if (column.nodes.empty()) return role_of_values(column.values, rows);
  if (std::optional<std::vector<NodeId>> const nodes = by_turns(column.nodes, rows)) {
    Role role = choose_role(sequence, loops, loop, {*nodes}, memory, copy);
    role.by_turn = true;
    return role;
  }
  if (sequence.source(column.nodes.front()) != Source::computed) {
    Role role = choose_role(sequence, loops, loop, column, memory, copy);
    return role.access.is_listed() && !nested(role.access, rows) ? std::nullopt : std::optional(role);
  }
  std::optional<Entry> entry = entry_of(column.nodes, rows, loop, sequence, loops, memory);
  if (!entry) return {};
  for (Entry const &known : entries)
    if (known.position == entry->position) return {}; // with other nodes, as columns are distinct
  memory.need_in_chain(loop, entry->position);
  Role role{Leaf::Kind::memory};
  role.cell = Cell{loop, entry->position, 0};
  role.in_chain = true;
  for (NodeId const node : entry->nodes) memory.need(node, memory.step_of_loop(loop));
  entries.push_back(std::move(*entry));
  return role;
}

} // namespace symreal::reroll
