// Order relations of two numbers, as sets. A comparison holds for a subset of them.
#pragma once

#include "engine/ops/operation.h"

namespace symreal::relation {

enum Of : unsigned { less = 1, equal = 2, greater = 4, unordered = 8, any = 15 }; // unordered: one of them is NaN

// Relations for which the comparison holds; the empty set if `op` is not a comparison of numbers.
inline unsigned held_by(Op op) {
  switch (op) {
  case Op::lt: return less;
  case Op::le: return less | equal;
  case Op::gt: return greater;
  case Op::ge: return greater | equal;
  case Op::eq: return equal;
  case Op::ne: return less | greater | unordered;
  default: return 0;
  }
}

// The relations with exchanged operands.
inline unsigned mirrored(unsigned set) {
  return (set & (equal | unordered)) | (set & less ? greater : 0u) | (set & greater ? less : 0u);
}

} // namespace symreal::relation
