#include "runtime/trace/leaks/x86_64/saved_state.h"

#include <cpuid.h>
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

// Offset of the XSAVE header, behind the FXSAVE area, in the standard format.
constexpr unsigned header = 512;
enum Component : unsigned { ymm_high = 2, zmm_high = 6, zmm_upper16 = 7 };

// Offset of a component, which the processor reports.
unsigned offset(Component component) {
  unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
  __cpuid_count(0xD, component, eax, ebx, ecx, edx);
  return ebx;
}

template <class T> T read(char const *at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

bool is_saved(char const *area, Component component) {
  // The bytes that FXSAVE leaves free, as Linux uses them.
  constexpr unsigned magic_at = 464, components_at = 472;
  constexpr std::uint32_t magic = 0x4650'5853;
  if (read<std::uint32_t>(area + magic_at) != magic) return false;
  std::uint64_t const components = read<std::uint64_t>(area + components_at) & read<std::uint64_t>(area + header);
  return (components >> component & 1) != 0;
}

} // namespace

AddressRegisters SavedState::address_registers() const {
  AddressRegisters registers;
  constexpr int order[] = {REG_RAX, REG_RCX, REG_RDX, REG_RBX, REG_RSP, REG_RBP, REG_RSI, REG_RDI,
                           REG_R8,  REG_R9,  REG_R10, REG_R11, REG_R12, REG_R13, REG_R14, REG_R15};
  for (unsigned i = 0; i < 16; ++i) registers.general[i] = static_cast<std::uint64_t>(general(order[i]));
  registers.instruction = instruction();
  asm("mov %%fs:0, %0" : "=r"(registers.thread)); // the ABI keeps the base there
  return registers;
}

std::uint64_t *SavedState::lane(unsigned vector, unsigned lane) const {
  auto *area = reinterpret_cast<char *>(context_.uc_mcontext.fpregs);
  auto const row = [&](std::size_t size, unsigned first) { return (vector - first) * size; };
  auto const column = [&](unsigned first) { return std::size_t{8} * (lane - first); };
  char *at = nullptr;
  if (vector >= 16)
    at = is_saved(area, zmm_upper16) ? area + offset(zmm_upper16) + row(64, 16) + column(0) : nullptr;
  else if (lane < 2)
    at = reinterpret_cast<char *>(context_.uc_mcontext.fpregs->_xmm) + row(16, 0) + column(0);
  else if (lane < 4)
    at = is_saved(area, ymm_high) ? area + offset(ymm_high) + row(16, 0) + column(2) : nullptr;
  else
    at = is_saved(area, zmm_high) ? area + offset(zmm_high) + row(32, 0) + column(4) : nullptr;
  return reinterpret_cast<std::uint64_t *>(at);
}

std::uint64_t *MaskedStep::place(SavedState const &state, Operand const &operand, unsigned lane) {
  return operand.in_memory ? reinterpret_cast<std::uint64_t *>(operand.address) + lane
                           : state.lane(operand.vector, lane);
}

void MaskedStep::substitute(Instruction const &instruction, Operand const &operand, unsigned lane, std::uint64_t *place,
                            std::uint64_t value) {
  bool const is_overwritten = !operand.in_memory && operand.vector == instruction.destination;
  if (!is_overwritten) changed_[count_++] = {operand, lane, *place};
  *place = value;
}

void MaskedStep::begin(SavedState &state) {
  state.mask_invalid();
  state.single_step(true);
  is_pending_ = true;
}

void MaskedStep::finish(SavedState &state, bool unmask) {
  is_pending_ = false;
  state.single_step(false);
  for (; count_ != 0; --count_) {
    Changed const &changed = changed_[count_ - 1];
    *place(state, changed.operand, changed.lane) = changed.original;
  }
  if (unmask) state.unmask_invalid();
}

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
