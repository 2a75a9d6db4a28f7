// Symbolic solution of small dense linear systems.
#pragma once

#include "engine/optimise/differentiate/expressions.h"

#include <optional>
#include <vector>

namespace symreal {

// Row-major; no_node for a structural zero.
using SquareMatrix = std::vector<std::vector<NodeId>>;

SquareMatrix transposed(SquareMatrix const &matrix);

// Gaussian elimination with partial pivoting. Selects choose the pivot of the largest magnitude, which differs among
// samples. Returns nullopt if the matrix is structurally singular.
std::optional<std::vector<NodeId>> solve(Expressions &expressions, SquareMatrix matrix, std::vector<NodeId> right);

} // namespace symreal
