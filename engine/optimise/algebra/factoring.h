// Algebraic factoring: parentheses are multiplied out, and common divisors extracted, the one that saves most first.
// After Brayton and McMullen, "The decomposition and factorization of Boolean expressions" (1982), with integers for
// coefficients.
#pragma once

#include "engine/optimise/algebra/expansion.h"
#include "engine/optimise/algebra/search.h"

namespace symreal::algebra {

struct FactoringSettings {
  ExpansionSettings expansion;
  double noise = 0;
  bool sums_first = false;
};

// A network with the same roots; it may be larger. The same for the same state of the search.
Network factored(Network const &network, FactoringSettings const &settings, Search &search);

} // namespace symreal::algebra
