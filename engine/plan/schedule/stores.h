// Which chunk of a long function body stores which results.
//
// All inputs are read before a result is stored, since the arrays may overlap, and all checks are made. So there is a
// first chunk that stores results: what is ready before waits for it in the work array, and what later chunks read of
// the input is copied there. It is the chunk for which the fewest numbers wait.
#pragma once

#include "engine/plan/schedule/schedule.h"

#include <span>
#include <vector>

namespace symreal {

struct Stores {
  std::size_t first_chunk = 0;                         // stores at its end; later ones behind what they compute
  std::vector<NodeId> copied = {};                     // at the end of the first chunk, before it stores
  std::vector<std::vector<std::size_t>> of_chunk = {}; // per chunk: the results that it stores
  std::vector<std::size_t> behind = {};                // those that none does
};

// What is known of the chunks. A node that is set nowhere, or read from no array, is in `never`.
struct ChunkReads {
  static constexpr std::uint32_t never = ~std::uint32_t{0};
  std::size_t chunk_count, first_storing;           // the first chunk that may store
  std::span<std::uint32_t const> set_in;            // per node: the chunk that sets its variable
  std::span<std::uint32_t const> last_reader;       // of its variable
  std::span<std::uint32_t const> last_array_reader; // of its element of an array
};

// No chunk stores more than `most`.
Stores distribute(Graph const &graph, FunctionBody const &body, ChunkReads const &reads, std::size_t most);

} // namespace symreal
