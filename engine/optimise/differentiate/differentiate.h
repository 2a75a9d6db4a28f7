// Derivatives as further outputs of a graph: jacobian(y, x) [rows of y][columns of x], gradient(y, x) [x], hessian(y,
// x) [x][x], jvp(y, x) [y] along the input direction_x, vjp(y, x) [x] of the outputs weighted with the input weights_y.
// They are defined by the derivatives in the table of operations and the chain rule: docs/reference/derivatives.md.
#pragma once

#include "engine/graph/graph.h"

#include <span>

namespace symreal {

// `graph` is as recorded: no pass has split it. One output for each request, behind those that there are. A Jacobian
// goes forward or backward, whichever costs less by the table. `report` is told what jumps. Throws bad_derivative,
// not_a_scalar, not_differentiable.
Graph differentiate(Graph graph, std::span<DerivativeWish const> wishes, Report const &report);

// Of a graph that has got derivatives, behind so many outputs of its own: the derivatives without these.
Graph derivatives_of(Graph graph, std::size_t own_outputs);

} // namespace symreal
