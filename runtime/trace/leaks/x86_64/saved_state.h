// Registers of an interrupted thread, as the kernel saved them for a signal handler and loads them again afterwards.
#pragma once

#include "runtime/trace/leaks/x86_64/instruction.h"

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

} // namespace symreal::trace::x86_64
