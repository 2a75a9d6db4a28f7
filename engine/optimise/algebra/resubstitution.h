// Resubstitution: a node computed from others that are there already, where that needs fewer operations.
//
// What the others must make up is looked up by its value: the difference or quotient of the node and another one. As in
// logic synthesis (Mishchenko and Brayton, "Scalable logic synthesis using a simple circuit structure", 2006), with
// numbers in place of truth tables.
#pragma once

#include "engine/optimise/algebra/search.h"

namespace symreal::algebra {

struct ResubstitutionSettings {
  std::size_t neighbours = 60;  // how many nodes near one are tried
  std::size_t pairs_among = 24; // of how many of them sums and products are
  double sideways = 0.3;        // how often a change is made that saves nothing, but may lead on
  bool largest_first = false;
};

// One sweep over all nodes. The same for the same state of the search.
Network resubstituted(Network const &network, ResubstitutionSettings const &settings, Search &search);

} // namespace symreal::algebra
