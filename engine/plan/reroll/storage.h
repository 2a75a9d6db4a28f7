// Storage allocation: offsets of blocks in an array, where blocks with disjoint live ranges share elements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace symreal::reroll {

// Live range of a value in memory: the steps of its first write and its last read.
struct Life {
  std::uint32_t first, last;

  void reach(std::uint32_t step) { last = step > last ? step : last; }
};

struct Block {
  std::size_t size;
  Life life;
};

struct Storage {
  std::vector<std::size_t> begins; // per block
  std::size_t size = 0;            // of the array
};

// First-fit allocation of the blocks, in order of the begin of their live ranges.
Storage stored(std::vector<Block> const &blocks);

} // namespace symreal::reroll
