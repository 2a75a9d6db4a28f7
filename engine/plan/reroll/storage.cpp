#include "engine/plan/reroll/storage.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>

namespace symreal::reroll {

namespace {

class Places {
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
  Places places;
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

} // namespace symreal::reroll
