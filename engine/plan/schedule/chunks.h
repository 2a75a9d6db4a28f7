// Chunks: a long function body cut into pieces of bounded size.
//
// C compilers take superlinear time on a huge function: one of 20 000 statements cost gcc four times as much as pieces
// of 300. A value used in one chunk only stays local; one that crosses chunks is spilled to an array.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

// Stores of the results, shared out to the chunks.
//
// Arrays may overlap, so all inputs must be read, and all guards checked, before a result is stored. The first storing
// chunk is therefore chosen so that the fewest values wait: results that are ready earlier wait in the work array, and
// inputs that later chunks read are copied there.
struct Stores {
  std::size_t first_chunk = 0;     // it stores at its end; later chunks store right behind each computation
  std::vector<NodeId> copied = {}; // copied at the end of the first chunk, before its stores
  std::vector<std::vector<std::size_t>> of_chunk = {}; // per chunk: results that it stores
  std::vector<std::size_t> behind = {};                // results that no chunk stores
};

struct Chunks {
  std::vector<std::size_t> begin = {};        // first statement of each chunk, and the end of the last
  std::vector<std::uint32_t> spill_slot = {}; // per node: slot that holds it for later chunks, or no_slot
  std::vector<std::uint32_t> copy_slot = {};  // per node read from an array: slot of its copy
  std::size_t spill_count = 0;                // size of the array; the slot of a dead value is reused
  std::vector<std::size_t> part = {};         // per chunk: its part of the body; empty if the body has no parts
  Stores stores = {};

  std::vector<std::uint32_t> statement = {}; // per node: the statement that sets its variable, or no_slot

  std::size_t size() const { return begin.size() - 1; }
  bool has_parts() const { return !part.empty(); }
  // Chunk of a check: that of the statements before it, whose variables it can read; behind all parts.
  std::size_t of_check(Check const &check) const;
};

struct ChunkLimits {
  std::size_t most_statements;
  bool may_store; // chunks may store results
};

// Cuts the body. A chunk respects `limits`, for its statements and its stored results, and has statements of one part
// only. Parts of one stage share no slot.
Chunks cut(Plan const &plan, PlanFunction const &body, ChunkLimits const &limits);

} // namespace symreal
