// Exceptions of the x87 unit, which computes in long double. It reports an exception late, at its next instruction, and
// leaves the operation pending, which is then completed here.
#pragma once

#include "runtime/trace/leaks/x86_64/saved_state.h"

namespace symreal::trace::x86_64 {

class PendingOperation {
public:
  explicit PendingOperation(SavedState &state);

  std::uintptr_t instruction() const { return instruction_; }
  // The double in memory that it reads; null if it reads none.
  std::uint64_t const *operand() const;
  // Carries it out as it is carried out where FE_INVALID is masked; with this operand instead, if it is not null.
  void complete(std::uint64_t const *substitute);

private:
  SavedState &state_;
  std::uintptr_t instruction_;
  std::uint8_t opcode_, modrm_; // D8..DF and the next byte
  std::uintptr_t address_;      // of the operand, if that is in memory
};

} // namespace symreal::trace::x86_64
