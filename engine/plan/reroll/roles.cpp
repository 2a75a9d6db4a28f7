#include "engine/plan/reroll/roles.h"

#include "engine/support/number.h"

#include <algorithm>

namespace symreal::reroll {

namespace {

std::vector<double> one_period(std::vector<double> values) {
  std::size_t period = 1;
  auto const repeats = [&] {
    return std::equal(values.begin() + static_cast<std::ptrdiff_t>(period), values.end(), values.begin(), same_bits);
  };
  while (2 * period <= values.size() && !repeats()) ++period;
  if (2 * period <= values.size()) values.resize(period);
  return values;
}

class MemoryRole {
public:
  MemoryRole(Sequence const &sequence, std::vector<LoopBody> const &loops, std::uint32_t loop,
             std::vector<NodeId> const &nodes, Memory &memory)
      : sequence_(sequence),
        loops_(loops),
        loop_(loop),
        nodes_(nodes),
        memory_(memory) {}

  Role choose(Copy const &copy) {
    Role role{Array::memory};
    if (std::ranges::all_of(nodes_, [&](NodeId node) { return node == nodes_.front(); })) {
      memory_.need(role.node = nodes_.front(), here());
      return role;
    }
    if (!find_line()) {
      for (NodeId node : nodes_) memory_.need(node, here());
      role.nodes = nodes_;
      return role;
    }
    if (is_carried()) {
      role.is_carried = true;
      role.next = cell_.position;
      for (std::size_t k : elsewhere_) memory_.need(role.nodes.emplace_back(nodes_[k]), here());
      return role;
    }
    memory_.need(cell_, here());
    for (std::size_t k : elsewhere_) copy(at(k), nodes_[k]);
    role.cell = cell_;
    role.step = step_;
    return role;
  }

private:
  std::uint32_t here() const { return memory_.step_of_loop(loop_); }

  Cell at(std::size_t k) const {
    return {cell_.loop, cell_.position, cell_.iteration + step_ * static_cast<std::int64_t>(k)};
  }

  // Two neighbours in the middle determine the line of cells; operands off the line must fit as copies at its ends.
  bool find_line() {
    std::size_t const middle = nodes_.size() / 2;
    std::optional<Cell> const a = memory_.cell(nodes_[middle]), b = memory_.cell(nodes_[middle - 1]);
    if (!a || !b || a->loop != b->loop || a->position != b->position) return false;
    if (std::ranges::any_of(nodes_, [&](NodeId node) { return memory_.is_overwritten(node); })) return false;
    step_ = a->iteration - b->iteration;
    cell_ = {a->loop, a->position, a->iteration - step_ * static_cast<std::int64_t>(middle)};
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      if (memory_.cell(nodes_[k]) == at(k)) continue;
      bool const is_known_before = sequence_.position[nodes_[k]] < loops_[loop_].repeat.begin;
      if (!is_known_before || !memory_.may_hold_copy(at(k), nodes_[k])) return false;
      elsewhere_.push_back(k);
    }
    return step_ != 0;
  }

  // Whether the operand is the value of a few iterations before, except in the first iterations.
  bool is_carried() const {
    constexpr std::size_t most_iterations = 4; // each takes a variable
    bool const is_before = cell_.loop == loop_ && step_ == 1 && cell_.iteration < 0;
    return is_before && elsewhere_.size() <= most_iterations &&
           cell_.iteration == -static_cast<std::int64_t>(elsewhere_.size());
  }

  Sequence const &sequence_;
  std::vector<LoopBody> const &loops_;
  std::uint32_t loop_;
  std::vector<NodeId> const &nodes_;
  Memory &memory_;
  Cell cell_ = {};
  std::int64_t step_ = 0;
  std::vector<std::size_t> elsewhere_; // iterations
};

Role plain_role(Sequence const &sequence, std::vector<LoopBody> const &loops, std::uint32_t loop, Column const &column,
                Memory &memory, Copy const &copy) {
  if (column.nodes.empty()) return role_of_values(column.values);
  Array const source = sequence.array(column.nodes.front());
  if (source == Array::memory) return MemoryRole(sequence, loops, loop, column.nodes, memory).choose(copy);
  std::vector<std::uint32_t> elements;
  for (NodeId node : column.nodes) elements.push_back(sequence.element(node));
  return {.array = source, .access = access_of(std::move(elements))};
}

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

std::optional<Role> role_in_rows(Sequence const &sequence, std::vector<LoopBody> const &loops, std::uint32_t loop,
                                 Nest const &rows, Column const &column, Memory &memory, Copy const &copy,
                                 std::vector<Entry> &entries) {
  // Signs may still differ from chain to chain here.
  if (column.nodes.empty()) return role_of_values(column.values, rows);
  if (std::optional<std::vector<NodeId>> const nodes = by_turns(column.nodes, rows)) {
    Role role = plain_role(sequence, loops, loop, {*nodes}, memory, copy);
    role.by_turn = true;
    return role;
  }
  if (sequence.array(column.nodes.front()) != Array::memory) {
    Role role = plain_role(sequence, loops, loop, column, memory, copy);
    return role.access.is_listed() && !nested(role.access, rows) ? std::nullopt : std::optional(role);
  }
  std::optional<Entry> entry = entry_of(column.nodes, rows, loop, sequence, loops, memory);
  if (!entry) return {};
  for (Entry const &known : entries)
    if (known.position == entry->position) return {}; // with other nodes, as columns are distinct
  memory.need({loop, entry->position, 0}, memory.step_of_loop(loop));
  Role role{Array::memory};
  role.cell = Cell{loop, entry->position, 0};
  role.in_chain = true;
  for (NodeId const node : entry->nodes) memory.need(node, memory.step_of_loop(loop));
  entries.push_back(std::move(*entry));
  return role;
}

} // namespace

Role role_of_values(std::vector<double> const &values, std::optional<Nest> const &nest) {
  if (nest) {
    if (std::optional<std::vector<double>> const of_turns = by_turns(values, *nest, same_bits)) {
      Role role = role_of_values(*of_turns);
      role.by_turn = true;
      return role;
    }
  }
  std::vector<double> period = one_period(values);
  if (period.size() == 1) return {.constant = period.front()};
  return {.values = std::move(period)};
}

std::optional<Role> choose_role(Sequence const &sequence, std::vector<LoopBody> const &loops, std::uint32_t loop,
                                Column const &column, Memory &memory, Copy const &copy, std::vector<Entry> &entries) {
  if (std::optional<Nest> const &rows = loops[loop].repeat.rows)
    return role_in_rows(sequence, loops, loop, *rows, column, memory, copy, entries);
  return plain_role(sequence, loops, loop, column, memory, copy);
}

Leaf leaf_of(Role const &role, Memory const &memory, std::optional<Nest> const &nest) {
  Leaf leaf{role.array, role.access, role.values, role.by_turn, role.is_carried};
  if (role.in_chain && role.cell) {
    leaf.access = memory.in_iterations(role.cell->loop, role.cell->position);
  } else if (role.cell) {
    leaf.access = {memory.element(*role.cell), role.step * memory.stride(role.cell->loop)};
  } else if (role.node != no_node) {
    leaf.access = {memory.home(role.node), 0};
  } else if (!role.nodes.empty()) {
    std::vector<std::uint32_t> elements;
    for (NodeId node : role.nodes) elements.push_back(memory.home(node));
    leaf.access = access_of(std::move(elements));
  }
  if (role.by_turn && role.array != Array::values) leaf.access = in_turns(leaf.access, *nest);
  return leaf;
}

} // namespace symreal::reroll
