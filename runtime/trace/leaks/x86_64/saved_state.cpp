#include "runtime/trace/leaks/x86_64/saved_state.h"

#include <cpuid.h>
#include <cstring>

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

} // namespace symreal::trace::x86_64
