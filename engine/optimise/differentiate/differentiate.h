// Differentiation: adds derivatives as outputs: jacobian(y, x) [rows of y][columns of x], gradient(y, x) [x],
// hessian(y, x) [x][x], jvp(y, x) [y] along the input direction_x, vjp(y, x) [x] of the outputs weighted with the input
// weights_y. The operation table and the chain rule define them: docs/reference/derivatives.md.
#pragma once

#include "engine/graph/graph.h"

#include <span>
#include <vector>

namespace symreal {

// Appends one output per request. `graph` is as recorded: no pass has split it. A Jacobian takes forward or reverse
// mode, whichever costs less by the cost table. `report` receives operations that jump. Throws bad_derivative,
// not_a_scalar, not_differentiable.
Graph differentiate(Graph graph, std::span<DerivativeWish const> wishes, Report const &report);

// The derivatives alone, without the graph's first `own_outputs` outputs.
Graph derivatives_of(Graph graph, std::size_t own_outputs);

// The whole matrix, row-major, from its stored elements.
std::vector<double> unpacked(DerivativeMatrix const &matrix, std::span<double const> stored);

} // namespace symreal
