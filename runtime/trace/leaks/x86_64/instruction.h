// What a floating-point instruction of x86-64 reads: as much of the encoding of SSE, AVX and AVX-512 as it takes to
// find the operands in double precision of an instruction that raised FE_INVALID. x87 instructions are not among them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace symreal::trace::x86_64 {

// The registers that an address is made of.
struct AddressRegisters {
  std::array<std::uint64_t, 16> general; // in the order of their encoding: rax, rcx, rdx, rbx, rsp, rbp, rsi, rdi, r8..
  std::uint64_t instruction = 0;         // rip: where the instruction begins
  std::uint64_t thread = 0;              // base of segment fs: objects with thread storage duration
};

// A source operand: lanes of 8 bytes, each a double, from the lowest on.
struct Operand {
  bool in_memory;
  unsigned vector;       // the number of the vector register
  std::uint64_t address; // where it is in memory
  unsigned lanes;
};

struct Instruction {
  unsigned length;
  std::vector<Operand> sources;        // none where the instruction reads no doubles
  std::optional<unsigned> destination; // the vector register that it writes
};

// Nothing, where this is no instruction that we know to raise FE_INVALID.
std::optional<Instruction> decode(std::uint8_t const *code, AddressRegisters const &registers);

} // namespace symreal::trace::x86_64
