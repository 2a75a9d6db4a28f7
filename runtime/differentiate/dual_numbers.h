// What derivatives are by dual numbers over the recorded graph.
#pragma once

#include "differentiate/request.h"
#include "graph/evaluate.h"

#include <span>
#include <vector>

namespace symreal {

// As Differences::at, at every point: what a kink or a pole has there the table says. `seeds`: of each request. A graph
// that calls functions has got those that give their derivatives, by add_derivative_functions.
std::vector<long double> dual_numbers(Graph const &graph, std::span<DerivativeRequest const> requests,
                                      std::span<std::span<double const> const> seeds, std::span<double const> inputs,
                                      std::span<double const> parameters, CallExternal const &call = {});

} // namespace symreal
