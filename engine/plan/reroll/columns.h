// Operands of a loop: per operation of its body the operand in each iteration.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// One operand over all iterations: nodes, or values if all are constants.
struct Column {
  std::vector<NodeId> nodes = {};
  std::vector<double> values = {};
};

inline constexpr std::uint32_t no_column = ~std::uint32_t{0};

// Operand that operation `position` of the same iteration computes, or that a column lists. `sign`: where sums and
// differences alternate, the column of 1 and -1 that multiplies it (exact, as is adding the negated operand).
struct BodyOperand {
  std::uint32_t position = no_position, column = no_column, sign = no_column;
  bool negated = false;
};

struct BodyOperation {
  Op op;
  NodeId first; // in the first iteration
  unsigned count = 0;
  std::array<BodyOperand, 3> operands = {};
};

struct LoopBody {
  Repeat repeat;
  std::vector<BodyOperation> operations;
  std::vector<Column> columns; // distinct
};

// Body of an aligned repeat. `uses`: per node how often it is an operand or a root.
LoopBody loop_body(Sequence const &sequence, Repeat const &repeat, std::vector<std::uint32_t> const &uses);

} // namespace symreal::reroll
