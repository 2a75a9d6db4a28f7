#include "engine/plan/reroll/memory.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace symreal::reroll {

namespace {

// Free elements of an array, as ranges.
class FreeRanges {
public:
  std::size_t take(std::size_t size) {
    auto place = std::ranges::find_if(free_, [&](auto const &range) { return range.second >= size; });
    if (place == free_.end()) place = grow(size);
    auto const [begin, length] = *place;
    free_.erase(place);
    if (length > size) free_.emplace(begin + size, length - size);
    return begin;
  }

  void give_back(std::size_t begin, std::size_t size) {
    auto const place = free_.emplace(begin, size).first;
    if (auto const next = std::next(place); next != free_.end() && begin + size == next->first) {
      place->second += next->second;
      free_.erase(next);
    }
    if (place == free_.begin()) return;
    if (auto const before = std::prev(place); before->first + before->second == begin) {
      before->second += place->second;
      free_.erase(place);
    }
  }

  std::size_t size() const { return size_; }

private:
  using Ranges = std::map<std::size_t, std::size_t>; // begin -> size

  // Range of this size at the end of the array; includes free elements there.
  Ranges::iterator grow(std::size_t size) {
    std::size_t begin = size_;
    if (!free_.empty() && std::prev(free_.end())->first + std::prev(free_.end())->second == size_) {
      begin = std::prev(free_.end())->first;
      free_.erase(begin);
    }
    size_ = begin + size;
    return free_.emplace(begin, size).first;
  }

  Ranges free_;
  std::size_t size_ = 0;
};

} // namespace

Storage stored(std::vector<Block> const &blocks) {
  std::vector<std::size_t> order(blocks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return blocks[k].life.first; });
  using Last = std::pair<std::uint32_t, std::size_t>; // last step and index of a block
  std::priority_queue<Last, std::vector<Last>, std::greater<>> alive;
  FreeRanges places;
  Storage storage{std::vector<std::size_t>(blocks.size())};
  for (std::size_t const k : order) {
    for (; !alive.empty() && alive.top().first < blocks[k].life.first; alive.pop())
      places.give_back(storage.begins[alive.top().second], blocks[alive.top().second].size);
    storage.begins[k] = places.take(blocks[k].size);
    alive.emplace(blocks[k].life.last, k);
  }
  storage.size = places.size();
  return storage;
}

Memory::Memory(Sequence const &sequence, std::vector<LoopBody> const &loops, std::vector<std::uint32_t> step_of)
    : sequence_(sequence),
      loops_(loops),
      step_of_(std::move(step_of)),
      loop_of_(sequence.size(), no_position),
      regions_(loops.size()) {
  for (std::uint32_t loop = 0; loop < loops.size(); ++loop) {
    Repeat const &repeat = loops[loop].repeat;
    std::fill(loop_of_.begin() + repeat.begin, loop_of_.begin() + repeat.end(), loop);
    regions_[loop].last = (repeat.rows ? length_of(*repeat.rows, repeat.rows->turns - 1) : repeat.count) - 1;
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
  is_overwritten_early_ = is_overwritten_early_ || is_overwritten(node);
  if (std::optional<Cell> const there = cell(node)) {
    if (!is_last(*there)) return need(*there, step);
    field(there->loop, there->position, step);
    return;
  }
  std::uint32_t const at = sequence_.position[node];
  // A node without an operation is in memory for the result copies; the step before them stores it.
  std::uint32_t const written = at == no_position ? step - 1 : step_of_[at];
  singles_.try_emplace(node, Place{{written, step}}).first->second.life.reach(step);
}

bool Memory::is_overwritten(NodeId node) const {
  std::optional<Cell> const there = cell(node);
  if (!there) return false;
  std::optional<Nest> const &rows = loops_[there->loop].repeat.rows;
  return rows && there->iteration < begin_of(*rows, rows->turns - 1);
}

void Memory::need_kept(NodeId node, std::uint32_t step) {
  std::optional<Cell> const there = cell(node);
  if (!there || !is_overwritten(node)) return need(node, step);
  std::uint32_t const written = step_of_loop(there->loop);
  regions_[there->loop].kept.try_emplace(there->position, Place{{written, step}}).first->second.life.reach(step);
}

void Memory::need(Cell const &cell, std::uint32_t step) { field(cell.loop, cell.position, step).of_last = false; }

// Field of an operation, with its live range extended to `step`.
Memory::Place &Memory::field(std::uint32_t loop, std::uint32_t position, std::uint32_t step) {
  Place &place = regions_[loop].fields.try_emplace(position, Place{{step_of_loop(loop), step}}).first->second;
  place.life.reach(step);
  return place;
}

bool Memory::is_last(Cell const &cell) const {
  Repeat const &repeat = loops_[cell.loop].repeat;
  return !repeat.rows && cell.iteration + 1 == static_cast<std::int64_t>(repeat.count);
}

std::vector<std::uint32_t> Memory::stored_positions(std::uint32_t loop) const {
  std::vector<std::uint32_t> positions;
  for (auto const &[position, place] : regions_[loop].fields) positions.push_back(position);
  return positions;
}

bool Memory::may_hold_copy(Cell const &cell, NodeId node) const {
  // Extra records are worth their memory near the ends of the loop only.
  std::int64_t const count = loops_[cell.loop].repeat.count;
  if (is_real(cell) || cell.iteration < -count || cell.iteration >= 2 * count) return false;
  if (loops_[cell.loop].repeat.rows && cell.iteration < 0) return false;
  auto const there = copies_.find(cell);
  return there == copies_.end() || there->second == node;
}

bool Memory::hold_copy(Cell const &cell, NodeId node, std::uint32_t step) {
  internal_check(may_hold_copy(cell, node));
  need(cell, step);
  Region &region = regions_[cell.loop];
  Life &life = region.fields.at(cell.position).life;
  life.first = std::min(life.first, step - 1);
  region.first = std::min(region.first, record(cell));
  region.last = std::max(region.last, record(cell));
  return copies_.try_emplace(cell, node).second;
}

void Memory::lay_out(std::vector<char> const &spread) {
  std::vector<Block> blocks;
  std::vector<std::pair<Place *, std::size_t>> elements; // each with its block
  for (auto &[node, place] : singles_) {
    elements.emplace_back(&place, 0);
    blocks.push_back({1, place.life});
  }
  std::vector<std::size_t> block_of; // per element
  for (std::size_t k = 0; k < blocks.size(); ++k) block_of.push_back(k);
  for (std::uint32_t loop = 0; loop < regions_.size(); ++loop) {
    Region &region = regions_[loop];
    bool const is_spread = spread[loop] || loops_[loop].repeat.rows;
    // Compilers vectorise only if each iteration stores to an element of its own.
    for (auto &[position, place] : region.fields) place.of_last = place.of_last && !is_spread;
    auto const fields = static_cast<std::size_t>(
        std::ranges::count_if(region.fields, [](auto const &entry) { return !entry.second.of_last; }));
    auto const records = static_cast<std::size_t>(region.last - region.first + 1);
    region.stride = is_spread ? 1 : static_cast<std::int64_t>(fields);
    std::size_t field = 0, shared = 0; // in the block of records that are not spread
    for (auto &[position, place] : region.fields) {
      if (is_spread || place.of_last) {
        blocks.push_back({place.of_last ? 1 : records, place.life});
        elements.emplace_back(&place, 0);
        block_of.push_back(blocks.size() - 1);
        continue;
      }
      if (field == 0) {
        shared = blocks.size();
        blocks.push_back({fields * records, place.life});
      }
      Life &life = blocks[shared].life;
      life.first = std::min(life.first, place.life.first);
      life.reach(place.life.last);
      elements.emplace_back(&place, field++);
      block_of.push_back(shared);
    }
    for (auto &[position, place] : region.kept) {
      if (auto const other = region.fields.find(position); other != region.fields.end())
        place.life.reach(other->second.life.last);
      blocks.push_back({loops_[loop].repeat.count, place.life});
      elements.emplace_back(&place, 0);
      block_of.push_back(blocks.size() - 1);
    }
  }
  Storage const storage = stored(blocks);
  for (std::size_t k = 0; k < elements.size(); ++k)
    elements[k].first->element = static_cast<std::uint32_t>(storage.begins[block_of[k]] + elements[k].second);
  size_ = storage.size;
}

bool Memory::has_home(NodeId node) const {
  if (std::optional<Cell> const there = cell(node))
    return regions_[there->loop].fields.contains(there->position) ||
           regions_[there->loop].kept.contains(there->position);
  return singles_.contains(node);
}

std::uint32_t Memory::home(NodeId node) const {
  std::optional<Cell> const there = cell(node);
  if (!there) return singles_.at(node).element;
  Region const &region = regions_[there->loop];
  auto const kept = region.kept.find(there->position);
  return kept == region.kept.end() ? element(*there)
                                   : kept->second.element + static_cast<std::uint32_t>(there->iteration);
}

std::uint32_t Memory::element(Cell const &cell) const {
  Region const &region = regions_[cell.loop];
  Place const &place = region.fields.at(cell.position);
  if (place.of_last) return place.element;
  std::int64_t const record = this->record(cell) - region.first;
  return static_cast<std::uint32_t>(place.element + record * region.stride);
}

// Record of a cell; chains that have not joined by the last row follow on that row.
std::int64_t Memory::record(Cell const &cell) const {
  Repeat const &repeat = loops_[cell.loop].repeat;
  if (!repeat.rows) return cell.iteration;
  if (is_real(cell)) return turn_of(*repeat.rows, static_cast<std::uint32_t>(cell.iteration)).inner;
  return cell.iteration - begin_of(*repeat.rows, repeat.rows->turns - 1);
}

std::vector<std::pair<std::uint32_t, Access>> Memory::kept_positions(std::uint32_t loop) const {
  std::vector<std::pair<std::uint32_t, Access>> result;
  for (auto const &[position, place] : regions_[loop].kept) result.push_back({position, {place.element, 1}});
  return result;
}

Access Memory::in_iterations(std::uint32_t loop, std::uint32_t position) const {
  std::optional<Nest> const &rows = loops_[loop].repeat.rows;
  std::uint32_t const first = element({loop, position, 0});
  if (!rows) return {first, regions_[loop].fields.at(position).of_last ? 0 : stride(loop)};
  Access access;
  for (std::uint32_t row = 0; row < rows->turns; ++row)
    for (std::int64_t chain = 0; chain < length_of(*rows, row); ++chain)
      access.elements.push_back(first + static_cast<std::uint32_t>(chain));
  return access;
}

} // namespace symreal::reroll
