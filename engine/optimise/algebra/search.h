// Random search: steps of factoring and resubstitution that are kept unless they enlarge the network.
#pragma once

#include "engine/optimise/algebra/expansion.h"

#include <cstdint>
#include <random>

namespace symreal::algebra {

// Random numbers and the work of a search.
struct SearchState {
  explicit SearchState(std::uint64_t seed) : random(seed) {}

  std::mt19937_64 random;
  std::uint64_t work = 0; // work done, in units of about an eighth of a microsecond
  // Work at which a step stops and keeps its partial result, whatever the size of the network.
  std::uint64_t end = ~std::uint64_t{0};

  bool is_over() const { return work >= end; }
  // Uniform in [0, 1).
  double chance() { return static_cast<double>(random() >> 11) * 0x1p-53; }
  template <class Item> void shuffle(std::vector<Item> &items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random() % i]);
  }
};

struct FactoringSettings {
  ExpansionSettings expansion;
  double noise = 0;
  bool sums_first = false;
};

// Algebraic factoring: expands parentheses, then extracts common divisors, the most profitable first. After Brayton and
// McMullen, "The decomposition and factorization of Boolean expressions" (1982), with integer coefficients.
//
// A network with the same roots, possibly larger. Deterministic for a given state of the search.
Network factored(Network const &network, FactoringSettings const &settings, SearchState &search);

// Resubstitution: recomputes a node from existing nodes if that needs fewer operations.
//
// The missing operand, the difference or quotient of the node and another one, is looked up by value. As in logic
// synthesis (Mishchenko and Brayton, "Scalable logic synthesis using a simple circuit structure", 2006), with numbers
// in place of truth tables.
//
// One sweep over all nodes, in random order or those with the most expensive fanout-free cones first. Deterministic for
// a given state of the search.
Network resubstituted(Network const &network, bool largest_first, SearchState &search);

struct WindowSettings {
  std::size_t length = 300; // operations per window
  int steps = 8;            // steps per window
};

// Window search: one pass over randomly cut stretches of a network, each of which is improved separately. The result
// may be larger if windows duplicate operations.
//
// Local gains decide, so that large networks gain as much as small ones, in time proportional to their size. Values
// from outside are known inside a window, so identities that depend on the whole network still hold in it.
Network improved_in_windows(Network const &network, WindowSettings const &settings, SearchState &search);

// Result of the full search: the best network, and the work, bounded by the effort times the operations that could be
// saved.
struct Searched {
  Network network;
  std::uint64_t work;
};
Searched searched(Network const &network, int effort);

} // namespace symreal::algebra
