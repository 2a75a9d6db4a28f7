// What the table of operations says of derivatives: a formula for each operand, or why there is none.
#pragma once

#include "engine/optimise/passes/term.h"

namespace symreal {

enum class Slope : std::uint8_t {
  formula,
  zero,   // a truth value, or the condition of a select: whoever decides by it has no slope of its own
  steps,  // constant between jumps: a rounding, an integer, an element of a table
  unknown // a function that the table cannot differentiate
};

// Of an operation by its operand `i`.
Slope slope_of(Op op, std::size_t i);
// The formula over the operands x, y, z and the result r.
Term const &derivative_of(Op op, std::size_t i);
// Whether it jumps although it has a formula between the jumps, as fmod.
bool jumps_between(Op op);

} // namespace symreal
