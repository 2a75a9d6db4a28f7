#include "reroll/memory.h"

#include <algorithm>

namespace symreal::reroll {

Memory::Memory(Sequence const &sequence, std::vector<LoopBody> const &loops, std::vector<std::uint32_t> step_of)
    : sequence_(sequence),
      loops_(loops),
      step_of_(std::move(step_of)),
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

void Memory::need(NodeId node, std::uint32_t step) {
  if (std::optional<Cell> const there = cell(node)) return need(*there, step);
  std::uint32_t const at = sequence_.position[node];
  // What no operation computes stands there for the results, and the step before their copies stores it.
  std::uint32_t const written = at == no_position ? step - 1 : step_of_[at];
  singles_.try_emplace(node, Place{{written, step}}).first->second.life.reach(step);
}

void Memory::need(Cell const &cell, std::uint32_t step) {
  std::uint32_t const written = step_of_loop(cell.loop);
  regions_[cell.loop].fields.try_emplace(cell.position, Place{{written, step}}).first->second.life.reach(step);
}

std::vector<std::uint32_t> Memory::stored_positions(std::uint32_t loop) const {
  std::vector<std::uint32_t> positions;
  for (auto const &[position, place] : regions_[loop].fields) positions.push_back(position);
  return positions;
}

bool Memory::may_hold_copy(Cell const &cell, NodeId node) const {
  // Records that nobody needs otherwise are worth it at the ends alone.
  std::int64_t const count = loops_[cell.loop].repeat.count;
  if (is_real(cell) || cell.iteration < -count || cell.iteration >= 2 * count) return false;
  auto const there = copies_.find(cell);
  return there == copies_.end() || there->second == node;
}

bool Memory::hold_copy(Cell const &cell, NodeId node, std::uint32_t step) {
  internal_check(may_hold_copy(cell, node));
  need(cell, step);
  Region &region = regions_[cell.loop];
  Life &life = region.fields.at(cell.position).life;
  life.first = std::min(life.first, step - 1);
  region.first = std::min(region.first, cell.iteration);
  region.last = std::max(region.last, cell.iteration);
  return copies_.try_emplace(cell, node).second;
}

void Memory::lay_out(std::vector<char> const &spread) {
  std::vector<Block> blocks;
  std::vector<std::pair<Place *, std::size_t>> elements; // each in its block
  for (auto &[node, place] : singles_) {
    elements.emplace_back(&place, 0);
    blocks.push_back({1, place.life});
  }
  std::vector<std::size_t> block_of; // per element
  for (std::size_t k = 0; k < blocks.size(); ++k) block_of.push_back(k);
  for (std::uint32_t loop = 0; loop < regions_.size(); ++loop) {
    Region &region = regions_[loop];
    std::size_t const fields = region.fields.size(), records = static_cast<std::size_t>(region.last - region.first + 1);
    region.stride = spread[loop] ? 1 : static_cast<std::int64_t>(fields);
    std::size_t field = 0;
    for (auto &[position, place] : region.fields) {
      if (spread[loop]) {
        blocks.push_back({records, place.life});
        elements.emplace_back(&place, 0);
      } else {
        if (field == 0) blocks.push_back({fields * records, place.life});
        Life &life = blocks.back().life;
        life.first = std::min(life.first, place.life.first);
        life.reach(place.life.last);
        elements.emplace_back(&place, field++);
      }
      block_of.push_back(blocks.size() - 1);
    }
  }
  Storage const storage = stored(blocks);
  for (std::size_t k = 0; k < elements.size(); ++k)
    elements[k].first->element = static_cast<std::uint32_t>(storage.begins[block_of[k]] + elements[k].second);
  size_ = storage.size;
}

bool Memory::has_home(NodeId node) const {
  if (std::optional<Cell> const there = cell(node)) return regions_[there->loop].fields.contains(there->position);
  return singles_.contains(node);
}

std::uint32_t Memory::home(NodeId node) const {
  std::optional<Cell> const there = cell(node);
  return there ? element(*there) : singles_.at(node).element;
}

std::uint32_t Memory::element(Cell const &cell) const {
  Region const &region = regions_[cell.loop];
  std::int64_t const record = cell.iteration - region.first;
  return static_cast<std::uint32_t>(region.fields.at(cell.position).element + record * region.stride);
}

} // namespace symreal::reroll
