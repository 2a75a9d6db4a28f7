// Random search: steps of factoring and resubstitution that are kept unless they enlarge the network.
#pragma once

#include "engine/optimise/algebra/network.h"

#include <cstdint>
#include <random>

namespace symreal::algebra {

struct Search {
  explicit Search(std::uint64_t seed) : random(seed) {}

  std::mt19937_64 random;
  std::uint64_t work = 0; // work done, in units of about an eighth of a microsecond
  // Work at which a step stops and keeps its partial result, whatever the size of the network.
  std::uint64_t end = ~std::uint64_t{0};

  bool is_over() const { return work >= end; }
};

// Takes `steps` steps on the whole network.
Network improved(Network network, int steps, Search &search);

// One factoring step that may enlarge the network, to escape a local minimum.
Network disturbed(Network const &network, Search &search);

// Result of the full search: the best network, and the work, bounded by the effort times the operations that could be
// saved.
struct Searched {
  Network network;
  std::uint64_t work;
};
Searched searched(Network const &network, int effort);

} // namespace symreal::algebra
