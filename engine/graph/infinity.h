// Infinities of the program's own: constants that stand for "none yet" or "no limit". Premise P1 of mode finite is
// about what is computed; such a constant may be compared with, selected, and handed on.
#pragma once

#include "engine/graph/node.h"

namespace symreal {

// Operations that compute nothing of an operand: the result is one of them, up to its sign.
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

// Operations that an infinity may reach: these, comparisons, and the lists of arguments of other functions.
inline bool takes_infinity(Op op) {
  return hands_on(op) || op == Op::argument || (info(op).has(flag::BOOLEAN) && !info(op).has(flag::LOGICAL));
}

} // namespace symreal
