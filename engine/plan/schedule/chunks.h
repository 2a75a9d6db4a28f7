// A long function body cut into pieces that compilers can digest.
//
// C compilers take more than linear time on one huge function: at 20 000 statements one function cost gcc four times
// what pieces of 300 did. Values that live inside one piece stay local; those that cross go through an array.
#pragma once

#include "engine/plan/schedule/schedule.h"
#include "engine/plan/schedule/stores.h"

namespace symreal {

struct Chunks {
  std::vector<std::size_t> begin = {};        // first statement of each chunk, and the end of the last
  std::vector<std::uint32_t> spill_slot = {}; // per node: where it is kept for later chunks, or no_slot
  std::vector<std::uint32_t> copy_slot = {};  // and what is found in an array: where its copy is
  std::size_t spill_count = 0;                // size of the array; slots are used again when their value is dead
  std::vector<std::size_t> part = {};         // per chunk, of the body's parts; none where it has none
  Stores stores = {};

  std::vector<std::uint32_t> statement = {}; // per node: that sets its variable, or no_slot

  std::size_t size() const { return begin.size() - 1; }
  bool has_parts() const { return !part.empty(); }
  // Where a check belongs: with the statements before it, whose variables it can read; behind all parts.
  std::size_t of_check(Check const &check) const;
};

struct ChunkLimits {
  std::size_t most_statements;
  bool may_store; // chunks may store results
};

// No chunk has more than so many statements, or statements of two parts, or stores more than so many results. Parts of
// one stage share no slot.
Chunks cut(Schedule const &plan, FunctionBody const &body, bool in_compute, ChunkLimits const &limits);

} // namespace symreal
