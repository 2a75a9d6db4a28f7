// Execution of one instruction with substituted operands and FE_INVALID masked: in place, up to the SIGTRAP that
// follows.
#pragma once

#include "runtime/trace/leaks/x86_64/saved_state.h"

#include <array>

namespace symreal::trace::x86_64 {

class MaskedStep {
public:
  // Address of the operand's lane, in memory or in the saved state. Null for a register that is not in use.
  static std::uint64_t *place(SavedState const &state, Operand const &operand, unsigned lane);

  void substitute(Instruction const &instruction, Operand const &operand, unsigned lane, std::uint64_t *place,
                  std::uint64_t value);
  void begin(SavedState &state);
  bool is_pending() const { return is_pending_; }
  // Restores the operands after the instruction, except where it has written its result.
  void finish(SavedState &state, bool unmask);

private:
  struct Changed {
    Operand operand = {};
    unsigned lane = 0;
    std::uint64_t original = 0;
  };
  std::array<Changed, 24> changed_ = {}; // three operands of eight lanes
  unsigned count_ = 0;
  bool is_pending_ = false;
};

} // namespace symreal::trace::x86_64
