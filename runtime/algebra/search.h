// Random steps of factoring and resubstitution, of which those are kept that do not make the network larger.
#pragma once

#include "algebra/network.h"

#include <random>

namespace symreal::algebra {

struct Search {
  explicit Search(std::uint64_t seed) : random(seed) {}

  std::mt19937_64 random;
  std::uint64_t work = 0; // what was done, in units of about an eighth of a microsecond
};

// So many steps on the whole of a network.
Network improved(Network network, int steps, Search &search);

// One step of factoring, though it may make the network larger: a way out of where no step leads on.
Network disturbed(Network const &network, Search &search);

} // namespace symreal::algebra
