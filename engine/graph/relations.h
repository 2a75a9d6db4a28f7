// How two numbers may stand to each other: a set of these. A comparison asks for some of them.
#pragma once

#include "engine/ops/operation.h"

namespace symreal::relation {

enum Of : unsigned { less = 1, equal = 2, greater = 4, unordered = 8, any = 15 }; // unordered: one of them is NaN

// Those for which the comparison holds; none: it compares no numbers.
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

// With the operands exchanged.
inline unsigned mirrored(unsigned set) {
  return (set & (equal | unordered)) | (set & less ? greater : 0u) | (set & greater ? less : 0u);
}

} // namespace symreal::relation
