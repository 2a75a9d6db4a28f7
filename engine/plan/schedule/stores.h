// Assignment of result stores to the chunks of a long function body.
//
// Arrays may overlap, so all inputs must be read, and all guards checked, before a result is stored. The first storing
// chunk is therefore chosen so that the fewest values wait: results that are ready earlier wait in the work array, and
// inputs that later chunks read are copied there.
#pragma once

#include "engine/plan/schedule/schedule.h"

#include <span>
#include <vector>

namespace symreal {

struct Stores {
  std::size_t first_chunk = 0;     // it stores at its end; later chunks store right behind each computation
  std::vector<NodeId> copied = {}; // copied at the end of the first chunk, before its stores
  std::vector<std::vector<std::size_t>> of_chunk = {}; // per chunk: results that it stores
  std::vector<std::size_t> behind = {};                // results that no chunk stores
};

// Uses of nodes in chunks. `never`: the node is not set, or not read from an array.
struct ChunkReads {
  static constexpr std::uint32_t never = ~std::uint32_t{0};
  std::size_t chunk_count, first_storing;           // the first chunk that may store
  std::span<std::uint32_t const> set_in;            // per node: the chunk that sets its variable
  std::span<std::uint32_t const> last_reader;       // per node: last chunk that reads its variable
  std::span<std::uint32_t const> last_array_reader; // per node: last chunk that reads its array element
};

// Assigns the stores, at most `most` per chunk.
Stores distribute(Graph const &graph, FunctionBody const &body, ChunkReads const &reads, std::size_t most);

} // namespace symreal
