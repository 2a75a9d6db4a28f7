// Where blocks stand in an array: those that are not needed at the same time share elements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace symreal::reroll {

// When somebody first writes and last reads what stands there, in steps.
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

// Block by block, as they come to life, at the first place that is free then.
Storage stored(std::vector<Block> const &blocks);

} // namespace symreal::reroll
