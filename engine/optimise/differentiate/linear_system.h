// Small dense systems of linear equations as expressions.
#pragma once

#include "engine/optimise/differentiate/expressions.h"

#include <optional>
#include <vector>

namespace symreal {

// Row by row; no_node where an element is zero by structure.
using SquareMatrix = std::vector<std::vector<NodeId>>;

SquareMatrix transposed(SquareMatrix const &matrix);

// By elimination. In each column the element of the largest magnitude becomes the pivot, by selects: which one that is
// differs from sample to sample. Nothing where the matrix is singular by structure.
std::optional<std::vector<NodeId>> solve(Expressions &expressions, SquareMatrix matrix, std::vector<NodeId> right);

} // namespace symreal
