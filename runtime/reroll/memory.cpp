#include "reroll/memory.h"

#include <algorithm>

namespace symreal::reroll {

Memory::Memory(Sequence const &sequence, std::vector<LoopBody> const &loops)
    : sequence_(sequence),
      loops_(loops),
      loop_of_(sequence.size(), no_position),
      regions_(loops.size()) {
  for (std::uint32_t loop = 0; loop < loops.size(); ++loop) {
    Repeat const &repeat = loops[loop].repeat;
    std::fill(loop_of_.begin() + repeat.begin, loop_of_.begin() + repeat.end(), loop);
    regions_[loop].last = repeat.count - 1;
  }
}

std::optional<Cell> Memory::cell(NodeId node) const {
  std::uint32_t const at = sequence_.position[node];
  if (at == no_position || loop_of_[at] == no_position) return {};
  Repeat const &repeat = loops_[loop_of_[at]].repeat;
  std::uint32_t const offset = at - repeat.begin;
  return Cell{loop_of_[at], offset % repeat.period, offset / repeat.period};
}

void Memory::need(NodeId node) {
  if (std::optional<Cell> const there = cell(node))
    need(*there);
  else
    singles_.try_emplace(node, 0);
}

bool Memory::may_hold_copy(Cell const &cell, NodeId node) const {
  // Records that nobody needs otherwise are worth it at the ends alone.
  std::int64_t const count = loops_[cell.loop].repeat.count;
  if (is_real(cell) || cell.iteration < -count || cell.iteration >= 2 * count) return false;
  auto const there = copies_.find(cell);
  return there == copies_.end() || there->second == node;
}

bool Memory::hold_copy(Cell const &cell, NodeId node) {
  internal_check(may_hold_copy(cell, node));
  need(cell);
  Region &region = regions_[cell.loop];
  region.first = std::min(region.first, cell.iteration);
  region.last = std::max(region.last, cell.iteration);
  return copies_.try_emplace(cell, node).second;
}

void Memory::lay_out() {
  size_ = 0;
  for (auto &[node, element] : singles_) element = static_cast<std::uint32_t>(size_++);
  for (Region &region : regions_) {
    std::uint32_t field = 0;
    for (auto &[position, element] : region.fields) element = field++;
    region.begin = size_;
    size_ += region.fields.size() * static_cast<std::size_t>(region.last - region.first + 1);
  }
}

bool Memory::has_home(NodeId node) const {
  if (std::optional<Cell> const there = cell(node)) return regions_[there->loop].fields.contains(there->position);
  return singles_.contains(node);
}

std::uint32_t Memory::home(NodeId node) const {
  std::optional<Cell> const there = cell(node);
  return there ? element(*there) : singles_.at(node);
}

std::uint32_t Memory::element(Cell const &cell) const {
  Region const &region = regions_[cell.loop];
  std::int64_t const record = cell.iteration - region.first;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(region.begin) + record * stride(cell.loop)) +
         region.fields.at(cell.position);
}

} // namespace symreal::reroll
