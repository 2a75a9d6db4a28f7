#include "engine/plan/reroll/direct_results.h"

#include "engine/plan/reroll/mirrors.h"
#include "engine/plan/reroll/nest.h"

#include <set>

namespace symreal::reroll {

namespace {

using Slots = std::set<std::uint32_t>;

// Removes one result per iteration, at an affine index of the iteration; nullopt if no such line exists.
std::optional<Access> take_line(std::vector<Slots> &iterations) {
  auto const is_line = [&](Access const &access) {
    for (std::size_t k = 0; k < iterations.size(); ++k)
      if (!iterations[k].contains(static_cast<std::uint32_t>(access.at(k)))) return false;
    return true;
  };
  for (std::uint32_t const first : iterations[0])
    for (std::uint32_t const second : iterations[1]) {
      Access access{first, static_cast<std::int64_t>(second) - static_cast<std::int64_t>(first)};
      if (!is_line(access)) continue;
      for (std::size_t k = 0; k < iterations.size(); ++k) iterations[k].erase(static_cast<std::uint32_t>(access.at(k)));
      return access;
    }
  return {};
}

// Likewise, at an affine index of a loop nest.
std::optional<Access> take_nest(std::vector<Slots> &iterations, std::optional<Nest> const &rows) {
  Access access;
  for (Slots const &slots : iterations) {
    if (slots.empty()) return {};
    access.elements.push_back(*slots.begin());
  }
  if (rows ? !nested(access, *rows) : !nest_of(static_cast<std::uint32_t>(iterations.size()), {&access})) return {};
  for (Slots &slots : iterations) slots.erase(slots.begin());
  return access;
}

std::optional<Access> take(std::vector<Slots> &iterations, std::optional<Nest> const &rows) {
  std::optional<Access> line = take_line(iterations);
  return line ? line : take_nest(iterations, rows);
}

} // namespace

DirectResults direct_results(Sequence const &sequence, std::vector<LoopBody> const &loops,
                             std::vector<NodeId> const &stored, std::vector<Mirror> const &mirrors,
                             Memory const &memory, std::size_t begin) {
  DirectResults results{std::vector<std::vector<LoopResult>>(loops.size()), {}, std::vector<char>(stored.size(), 0)};
  for (Mirror const &mirror : mirrors)
    for_each_copy(mirror, [&](std::uint32_t to, std::uint32_t) { results.is_stored[to] = 1; });
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Slots>> by_operation; // per operation, iteration
  for (std::uint32_t slot = 0; slot < stored.size(); ++slot) {
    NodeId const node = stored[slot];
    if (results.is_stored[slot] || !sequence.is_computed(node) || sequence.position[node] < begin) continue;
    if (std::optional<Cell> const cell = memory.cell(node)) {
      std::vector<Slots> &iterations = by_operation[{cell->loop, cell->position}];
      iterations.resize(loops[cell->loop].repeat.count);
      iterations[static_cast<std::size_t>(cell->iteration)].insert(slot);
    } else {
      results.of_operation[node].push_back(slot);
      results.is_stored[slot] = 1;
    }
  }
  for (auto &[operation, iterations] : by_operation)
    while (auto const found = take(iterations, loops[operation.first].repeat.rows)) {
      for (std::size_t k = 0; k < iterations.size(); ++k) results.is_stored[found->at(k)] = 1;
      results.of_loop[operation.first].push_back({operation.second, *found});
    }
  return results;
}

} // namespace symreal::reroll
