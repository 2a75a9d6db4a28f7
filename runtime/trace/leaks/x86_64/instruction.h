// Decoder for the operands of x86-64 floating-point instructions: as much of SSE, AVX and AVX-512 as it takes to find
// the double-precision operands of an instruction that raised FE_INVALID. x87 instructions are not decoded.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace symreal::trace::x86_64 {

// The registers that form an address.
struct AddressRegisters {
  std::array<std::uint64_t, 16> general; // in the order of their encoding: rax, rcx, rdx, rbx, rsp, rbp, rsi, rdi, r8..
  std::uint64_t instruction = 0;         // rip: address of the instruction
  std::uint64_t thread = 0;              // base of segment fs: objects with thread storage duration
};

// A source operand: lanes of 8 bytes, each a double, from the lowest on.
struct Operand {
  bool in_memory;
  unsigned vector;       // the number of the vector register
  std::uint64_t address; // of a memory operand
  unsigned lanes;
};

struct Instruction {
  unsigned length;
  std::vector<Operand> sources;        // empty if the instruction reads no doubles
  std::optional<unsigned> destination; // the vector register that it writes
};

// Nullopt unless the instruction is known to raise FE_INVALID.
std::optional<Instruction> decode(std::uint8_t const *code, AddressRegisters const &registers);

} // namespace symreal::trace::x86_64
