// Infinite constants of the program, which stand for "none yet" or "no limit". Premise P1 of mode finite covers
// computed values only; such a constant may be compared, selected, and passed on.
#pragma once

#include "engine/graph/node.h"

namespace symreal {

// Operations whose result is one of the operands, up to its sign.
inline bool hands_on(Op op) {
  switch (op) {
  case Op::select:
  case Op::fmin:
  case Op::fmax:
  case Op::neg:
  case Op::abs:
  case Op::copysign: return true;
  default: return false;
  }
}

// Operations that may take an infinity: those above, comparisons, and argument lists of external functions.
inline bool takes_infinity(Op op) {
  return hands_on(op) || op == Op::argument || (info(op).has(flag::BOOLEAN) && !info(op).has(flag::LOGICAL));
}

} // namespace symreal
