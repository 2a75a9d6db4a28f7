// Algebraic factoring: expands parentheses, then extracts common divisors, the most profitable first. After Brayton and
// McMullen, "The decomposition and factorization of Boolean expressions" (1982), with integer coefficients.
#pragma once

#include "engine/optimise/algebra/expansion.h"
#include "engine/optimise/algebra/search.h"

namespace symreal::algebra {

struct FactoringSettings {
  ExpansionSettings expansion;
  double noise = 0;
  bool sums_first = false;
};

// A network with the same roots, possibly larger. Deterministic for a given state of the search.
Network factored(Network const &network, FactoringSettings const &settings, Search &search);

} // namespace symreal::algebra
