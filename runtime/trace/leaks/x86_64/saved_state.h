// Registers of an interrupted thread, as the kernel saved them for a signal handler and loads them again afterwards;
// and the completion of the instruction that raised FE_INVALID, with carried values in the place of nodes.
#pragma once

#include "runtime/trace/leaks/x86_64/instruction.h"

#include <array>
#include <ucontext.h>

namespace symreal::trace::x86_64 {

inline constexpr unsigned invalid_flag = 1;          // in MXCSR and in the x87 status word
inline constexpr unsigned mxcsr_invalid_mask = 0x80; // in MXCSR
inline constexpr unsigned x87_invalid_mask = 1;      // in the x87 control word

class SavedState {
public:
  explicit SavedState(void *context) : context_(*static_cast<ucontext_t *>(context)) {}

  AddressRegisters address_registers() const;
  std::uintptr_t instruction() const { return static_cast<std::uintptr_t>(general(REG_RIP)); }
  // The exception came from the x87 unit: it belongs to an instruction before this one.
  bool is_x87() const { return general(REG_TRAPNO) == 16; }

  // A lane of a vector register; null if the register is not in use and holds zeros.
  std::uint64_t *lane(unsigned vector, unsigned lane) const;

  void mask_invalid() { fpu().mxcsr |= mxcsr_invalid_mask; }
  void unmask_invalid() { fpu().mxcsr &= ~mxcsr_invalid_mask; }
  void raise_invalid() { fpu().mxcsr |= invalid_flag; }

  // Sets whether a SIGTRAP follows the next instruction.
  void single_step(bool on) {
    constexpr greg_t trap_flag = 0x100;
    general(REG_EFL) = on ? general(REG_EFL) | trap_flag : general(REG_EFL) & ~trap_flag;
  }
  greg_t &flags() { return general(REG_EFL); }
  // The x87 unit, vector registers and control words, in the format of FXSAVE.
  _libc_fpstate &fpu() const { return *context_.uc_mcontext.fpregs; }

private:
  greg_t &general(int index) { return context_.uc_mcontext.gregs[index]; }
  greg_t general(int index) const { return context_.uc_mcontext.gregs[index]; }

  ucontext_t &context_;
};

// Execution of one instruction with substituted operands and FE_INVALID masked: in place, up to the SIGTRAP that
// follows.
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

// A pending operation of the x87 unit, which computes in long double. It reports an exception late, at its next
// instruction, and leaves the operation pending, which is then completed here.
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
