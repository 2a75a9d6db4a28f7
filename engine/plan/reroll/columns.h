// The operands of a loop: per operation of its body what it computes with, iteration by iteration.
#pragma once

#include "engine/plan/reroll/repeats.h"

namespace symreal::reroll {

// The same operand in all iterations. Of numbers that are no constants the nodes, otherwise the values.
struct Column {
  std::vector<NodeId> nodes = {};
  std::vector<double> values = {};
};

inline constexpr std::uint32_t no_column = ~std::uint32_t{0};

// An operand is computed by operation `position` of the same iteration, or stands in a column. `sign`: where sums and
// differences alternate, a column of 1 and -1 with which it is multiplied: exact, as the addition is then.
struct BodyOperand {
  std::uint32_t position = no_position, column = no_column, sign = no_column;
  bool negated = false;
};

struct BodyOperation {
  Op op;
  NodeId first; // of the first iteration
  unsigned count = 0;
  std::array<BodyOperand, 3> operands = {};
};

struct LoopBody {
  Repeat repeat;
  std::vector<BodyOperation> operations;
  std::vector<Column> columns; // all different
};

// Of a repeat whose iterations are aligned. `uses`: per node how often it is an operand or a root.
LoopBody loop_body(Sequence const &sequence, Repeat const &repeat, std::vector<std::uint32_t> const &uses);

} // namespace symreal::reroll
