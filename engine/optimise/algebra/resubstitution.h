// Resubstitution: recomputes a node from existing nodes if that needs fewer operations.
//
// The missing operand, the difference or quotient of the node and another one, is looked up by value. As in logic
// synthesis (Mishchenko and Brayton, "Scalable logic synthesis using a simple circuit structure", 2006), with numbers
// in place of truth tables.
#pragma once

#include "engine/optimise/algebra/search.h"

namespace symreal::algebra {

struct ResubstitutionSettings {
  std::size_t neighbours = 60;  // nodes tried per target
  std::size_t pairs_among = 24; // neighbours that are combined in pairs
  double sideways = 0.3;        // probability of accepting a change without gain
  bool largest_first = false;
};

// One sweep over all nodes. Deterministic for a given state of the search.
Network resubstituted(Network const &network, ResubstitutionSettings const &settings, Search &search);

} // namespace symreal::algebra
