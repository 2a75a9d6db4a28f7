// Random steps of factoring and resubstitution, of which those are kept that do not make the network larger.
#pragma once

#include "engine/optimise/algebra/network.h"

#include <cstdint>
#include <random>

namespace symreal::algebra {

struct Search {
  explicit Search(std::uint64_t seed) : random(seed) {}

  std::mt19937_64 random;
  std::uint64_t work = 0; // what was done, in units of about an eighth of a microsecond
  // Where a step stops at once, with what it has: no step is longer than that, however large what it works on is.
  std::uint64_t end = ~std::uint64_t{0};

  bool is_over() const { return work >= end; }
};

// So many steps on the whole of a network.
Network improved(Network network, int steps, Search &search);

// One step of factoring, though it may make the network larger: a way out of where no step leads on.
Network disturbed(Network const &network, Search &search);

// All of it, as far as the effort goes: the best network that was found, and the work, which is bounded by the effort
// times what there is to save.
struct Searched {
  Network network;
  std::uint64_t work;
};
Searched searched(Network const &network, int effort);

} // namespace symreal::algebra
