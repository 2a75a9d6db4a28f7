// Derivative rules of the operation table: a formula per operand, or the reason for its absence.
#pragma once

#include "engine/optimise/passes/term.h"

namespace symreal {

enum class Slope : std::uint8_t {
  formula,
  zero,   // a truth value, or the condition of a select
  steps,  // constant between jumps: a rounding, an integer, an element of a table
  unknown // a function without a rule in the table
};

// Slope of an operation by its operand `i`.
Slope slope_of(Op op, std::size_t i);
// Formula over the operands x, y, z and the result r.
Term const &derivative_of(Op op, std::size_t i);
// Whether the operation jumps although it has a formula between the jumps, as fmod does.
bool jumps_between(Op op);

} // namespace symreal
