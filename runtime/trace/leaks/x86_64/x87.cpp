#include "runtime/trace/leaks/x86_64/x87.h"

#include <cstring>

// All x87 instructions, each followed by a return: at 4 * (256 * (opcode - D8) + modrm). Those with a memory operand
// are called with modrm for (%rdi).
asm(R"(
  .pushsection .text
  .local symreal_x87_instructions
symreal_x87_instructions:
  .set symreal_x87_index, 0
  .rept 2048
  .byte 0xD8 + symreal_x87_index / 256, symreal_x87_index & 255, 0xC3, 0x90
  .set symreal_x87_index, symreal_x87_index + 1
  .endr
  .popsection
)");

namespace symreal::trace::x86_64 {

namespace {

constexpr unsigned exception_summary = 0x80, busy = 0x8000; // in the status word

struct alignas(16) Area {
  unsigned char bytes[512];
};

// Runs one instruction on the unit in the state of `area`, and returns the processor's flags after it.
std::uint64_t run(std::uint8_t opcode, std::uint8_t modrm, void const *operand, Area &area) {
  Area mine;
  std::uint64_t flags, code = 1024u * (opcode - 0xD8u) + 4u * modrm;
  // The call must not touch the 128 bytes below the stack pointer. Our own vector registers come back with our state.
  asm volatile("lea symreal_x87_instructions(%%rip), %%rax\n\t"
               "add %%rax, %[code]\n\t"
               "lea -128(%%rsp), %%rsp\n\t"
               "fxsave64 (%[mine])\n\t"
               "fxrstor64 (%[area])\n\t"
               "call *%[code]\n\t"
               "pushf\n\t"
               "fxsave64 (%[area])\n\t"
               "fxrstor64 (%[mine])\n\t"
               "pop %[flags]\n\t"
               "lea 128(%%rsp), %%rsp"
               : [flags] "=&r"(flags), [code] "+&r"(code)
               : [mine] "r"(&mine), [area] "r"(&area), "D"(operand)
               : "rax", "cc", "memory");
  return flags;
}

bool is_prefix(std::uint8_t byte) {
  return byte == 0x64 || byte == 0x65 || byte == 0x66 || byte == 0x67 || byte == 0x2E || byte == 0x36 || byte == 0x3E ||
         byte == 0x26 || byte >> 4 == 4; // the last are REX
}

} // namespace

PendingOperation::PendingOperation(SavedState &state)
    : state_(state),
      instruction_(state.fpu().rip),
      address_(state.fpu().rdp) {
  auto const *code = reinterpret_cast<std::uint8_t const *>(instruction_);
  for (; is_prefix(*code); ++code)
    if (*code == 0x64) address_ += state.address_registers().thread;
  opcode_ = code[0];
  modrm_ = code[1];
}

std::uint64_t const *PendingOperation::operand() const {
  bool const in_memory = modrm_ < 0xC0, loads = (modrm_ >> 3 & 7) == 0;
  bool const is_double = opcode_ == 0xDC || (opcode_ == 0xDD && loads);
  return in_memory && is_double ? reinterpret_cast<std::uint64_t const *>(address_) : nullptr;
}

void PendingOperation::complete(std::uint64_t const *substitute) {
  _libc_fpstate &fpu = state_.fpu();
  Area area;
  std::memcpy(&area, &fpu, sizeof area);
  auto &copy = reinterpret_cast<_libc_fpstate &>(area);
  constexpr auto raised = static_cast<std::uint16_t>(invalid_flag | exception_summary | busy);
  copy.cwd |= x87_invalid_mask;
  copy.swd &= static_cast<std::uint16_t>(~raised);
  copy.mxcsr |= mxcsr_invalid_mask;
  bool const in_memory = modrm_ < 0xC0;
  void const *operand = substitute ? substitute : reinterpret_cast<void const *>(address_);
  std::uint64_t const flags =
      run(opcode_, in_memory ? static_cast<std::uint8_t>((modrm_ & 0x38) | 7) : modrm_, operand, area);

  // The flag would be pending at once if it stayed in the status word: it goes to MXCSR, where fetestexcept looks too.
  if ((copy.swd & invalid_flag) != 0) state_.raise_invalid();
  fpu.swd = static_cast<std::uint16_t>(copy.swd & ~raised);
  fpu.ftw = copy.ftw;
  std::memcpy(fpu._st, copy._st, sizeof fpu._st);
  // fcomi and fcomip, which compilers follow with an instruction of this unit before they branch.
  constexpr std::uint64_t zero_parity_carry = 0x45;
  bool const sets_flags = (opcode_ == 0xDB || opcode_ == 0xDF) && modrm_ >= 0xE8 && modrm_ <= 0xF7;
  if (sets_flags)
    state_.flags() = static_cast<greg_t>((static_cast<std::uint64_t>(state_.flags()) & ~zero_parity_carry) |
                                         (flags & zero_parity_carry));
}

} // namespace symreal::trace::x86_64
