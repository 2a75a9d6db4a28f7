// Operation counts, per operation.
#pragma once

#include "engine/ops/operation.h"

#include <array>
#include <cstddef>

namespace symreal {

struct OperationCounts {
  std::array<std::size_t, static_cast<std::size_t>(Op::count)> by_op{};

  std::size_t &operator[](Op op) { return by_op[static_cast<std::size_t>(op)]; }
  std::size_t operator[](Op op) const { return by_op[static_cast<std::size_t>(op)]; }
  // Number of + - * /; negations and functions are excluded.
  std::size_t arithmetic() const { return (*this)[Op::add] + (*this)[Op::sub] + (*this)[Op::mul] + (*this)[Op::div]; }
  std::size_t calls() const {
    std::size_t sum = 0;
    for (OperationInfo const &operation : operations())
      if (operation.form == Form::call) sum += (*this)[operation.op];
    return sum;
  }
};

} // namespace symreal
