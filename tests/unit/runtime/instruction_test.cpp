// The decoder of operands, on what the assembler makes of instructions.
#ifdef __x86_64__
#include "runtime/trace/leaks/x86_64/instruction.h"

#include <gtest/gtest.h>

#include <cstring>
#include <ostream>

// The bytes of an instruction, never executed.
#define ENCODED(name, instruction)                                                                                     \
  asm(".pushsection .rodata\n.intel_syntax noprefix\n" #name ":\n" instruction "\n" #name "_end:\n"                    \
      ".att_syntax prefix\n.popsection");                                                                              \
  extern "C" std::uint8_t const name[], name##_end[];

namespace symreal::trace::x86_64 {

bool operator==(Operand const &a, Operand const &b) {
  return a.in_memory == b.in_memory && a.vector == b.vector && a.address == b.address && a.lanes == b.lanes;
}
std::ostream &operator<<(std::ostream &out, Operand const &x) {
  return x.in_memory ? out << "[" << std::hex << x.address << std::dec << "]:" << x.lanes
                     : out << "v" << x.vector << ":" << x.lanes;
}

namespace {

Operand in(unsigned vector, unsigned lanes = 1) { return {false, vector, 0, lanes}; }
Operand at(std::uint64_t address, unsigned lanes = 1) { return {true, 0, address, lanes}; }
constexpr int other = -1; // the destination is no vector register

// Register k holds 0x1000 * (k + 1); the instruction stands at 0x100000, fs at 0x200000.
AddressRegisters registers() {
  AddressRegisters registers;
  for (unsigned k = 0; k < 16; ++k) registers.general[k] = 0x1000u * (k + 1);
  registers.instruction = 0x100000;
  registers.thread = 0x200000;
  return registers;
}

void expect(std::uint8_t const *code, std::uint8_t const *end, std::vector<Operand> const &sources, int destination) {
  std::optional<Instruction> const found = decode(code, registers());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->length, end - code);
  EXPECT_EQ(found->sources, sources);
  EXPECT_EQ(found->destination ? static_cast<int>(*found->destination) : other, destination);
}

#define EXPECT_OPERANDS(name, instruction, destination, ...)                                                           \
  ENCODED(name, instruction)                                                                                           \
  TEST(Instruction, name) { expect(name, name##_end, {__VA_ARGS__}, destination); }

// Two operands, of which the first is also the destination.
EXPECT_OPERANDS(adds, "addsd xmm1, xmm2", 1, in(1), in(2))
EXPECT_OPERANDS(adds_high, "addsd xmm9, xmm12", 9, in(9), in(12))
EXPECT_OPERANDS(muls_base, "mulsd xmm0, qword ptr [rax]", 0, in(0), at(0x1000))
EXPECT_OPERANDS(subs_disp8, "subsd xmm0, qword ptr [rbp-8]", 0, in(0), at(0x5FF8))
EXPECT_OPERANDS(divs_disp32, "divsd xmm0, qword ptr [r13+0x12345]", 0, in(0), at(0xE000 + 0x12345))
EXPECT_OPERANDS(mins_stack, "minsd xmm0, qword ptr [rsp+16]", 0, in(0), at(0x5010))
EXPECT_OPERANDS(maxs_index, "maxsd xmm3, qword ptr [r12+r9*8-0x10]", 3, in(3), at(0xD000 + 8 * 0xA000 - 0x10))
EXPECT_OPERANDS(adds_no_base, "addsd xmm0, qword ptr [rcx*8+0x400]", 0, in(0), at(8 * 0x2000 + 0x400))
EXPECT_OPERANDS(adds_absolute, "addsd xmm0, qword ptr ds:0x4000", 0, in(0), at(0x4000))
EXPECT_OPERANDS(adds_thread, "addsd xmm0, qword ptr fs:0xffffffffffffff00", 0, in(0), at(0x1FFF00))
EXPECT_OPERANDS(adds_short_address, "addsd xmm0, qword ptr [eax-0x2000]", 0, in(0), at(0xFFFFF000))
EXPECT_OPERANDS(adds_relative, "addsd xmm8, qword ptr [rip+0x20]", 8, in(8), at(0x100000 + 9 + 0x20))
EXPECT_OPERANDS(cmps_relative, "cmpltsd xmm0, qword ptr [rip+0x20]", 0, in(0), at(0x100000 + 9 + 0x20))
EXPECT_OPERANDS(mulp, "mulpd xmm0, xmmword ptr [rdi]", 0, in(0, 2), at(0x8000, 2))
EXPECT_OPERANDS(addsubp, "addsubpd xmm0, xmm1", 0, in(0, 2), in(1, 2))
EXPECT_OPERANDS(haddp, "haddpd xmm0, xmm1", 0, in(0, 2), in(1, 2))
EXPECT_OPERANDS(dot, "dppd xmm0, xmm1, 0x31", 0, in(0, 2), in(1, 2))

// What the destination held before is no operand.
EXPECT_OPERANDS(sqrts, "sqrtsd xmm0, xmm1", 0, in(1))
EXPECT_OPERANDS(rounds, "roundsd xmm0, qword ptr [rip+0x20], 1", 0, at(0x100000 + 10 + 0x20))
EXPECT_OPERANDS(to_float, "cvtsd2ss xmm0, xmm1", 0, in(1))
EXPECT_OPERANDS(to_floats, "cvtpd2ps xmm0, xmm1", 0, in(1, 2))
EXPECT_OPERANDS(to_ints, "cvttpd2dq xmm2, xmmword ptr [rsi]", 2, at(0x7000, 2))

// The result is no number.
EXPECT_OPERANDS(unordered, "ucomisd xmm0, xmm1", other, in(0), in(1))
EXPECT_OPERANDS(ordered, "comisd xmm8, qword ptr [rdx]", other, in(8), at(0x3000))
EXPECT_OPERANDS(to_int, "cvttsd2si eax, xmm5", other, in(5))
EXPECT_OPERANDS(to_long, "cvtsd2si r10, xmm0", other, in(0))

// Floats hold no node.
EXPECT_OPERANDS(float_add, "addss xmm0, xmm1", 0)
EXPECT_OPERANDS(float_compare, "ucomiss xmm0, xmm1", other)
EXPECT_OPERANDS(float_to_double, "cvtss2sd xmm0, xmm1", 0)

EXPECT_OPERANDS(vex_add, "vaddsd xmm1, xmm2, xmm3", 1, in(2), in(3))
EXPECT_OPERANDS(vex_high, "vsubsd xmm9, xmm10, xmm11", 9, in(10), in(11))
EXPECT_OPERANDS(vex_index, "vmulsd xmm1, xmm2, qword ptr [r8+r9*4+8]", 1, in(2), at(0x9000 + 4 * 0xA000 + 8))
EXPECT_OPERANDS(vex_sqrt, "vsqrtsd xmm1, xmm2, xmm3", 1, in(3))
EXPECT_OPERANDS(vex_wide, "vdivpd ymm1, ymm2, ymmword ptr [rbx]", 1, in(2, 4), at(0x4000, 4))
EXPECT_OPERANDS(vex_compare, "vcomisd xmm1, xmm12", other, in(1), in(12))
EXPECT_OPERANDS(vex_to_int, "vcvttsd2si rax, xmm1", other, in(1))
EXPECT_OPERANDS(vex_to_floats, "vcvtpd2ps xmm1, ymm2", 1, in(2, 4))
EXPECT_OPERANDS(fma_scalar, "vfmadd213sd xmm1, xmm2, qword ptr [rax]", 1, in(1), in(2), at(0x1000))
EXPECT_OPERANDS(fma_packed, "vfnmadd231pd ymm1, ymm2, ymm13", 1, in(1, 4), in(2, 4), in(13, 4))
EXPECT_OPERANDS(fma_float, "vfmadd213ss xmm1, xmm2, xmm3", 1)

EXPECT_OPERANDS(evex_high, "vaddsd xmm17, xmm18, xmm31", 17, in(18), in(31))
EXPECT_OPERANDS(evex_wide, "vmulpd zmm1, zmm20, zmmword ptr [rax+128]", 1, in(20, 8), at(0x1080, 8))
EXPECT_OPERANDS(evex_unaligned, "vmulpd zmm1, zmm20, zmmword ptr [rax+1]", 1, in(20, 8), at(0x1001, 8))
EXPECT_OPERANDS(evex_scalar, "vminsd xmm20, xmm1, qword ptr [rax-16]", 20, in(1), at(0xFF0))
EXPECT_OPERANDS(evex_broadcast, "vaddpd ymm20, ymm1, qword ptr [rax+8]{1to4}", 20, in(1, 4), at(0x1008))
EXPECT_OPERANDS(evex_compare, "vcmppd k1, zmm1, zmm2, 1", other, in(1, 8), in(2, 8))
EXPECT_OPERANDS(evex_to_unsigned, "vcvttsd2usi rax, xmm20", other, in(20))
EXPECT_OPERANDS(evex_to_unsigneds, "vcvttpd2udq ymm1, zmm2", 1, in(2, 8))
EXPECT_OPERANDS(evex_round, "vrndscalesd xmm1, xmm2, xmm23, 3", 1, in(23))
EXPECT_OPERANDS(evex_fma, "vfmsub132pd zmm1, zmm2, zmm3", 1, in(1, 8), in(2, 8), in(3, 8))

ENCODED(no_arithmetic, "movsd xmm0, xmm1")
ENCODED(integers, "add rax, rbx")
TEST(Instruction, OthersAreNotKnown) {
  EXPECT_FALSE(decode(no_arithmetic, registers()));
  EXPECT_FALSE(decode(integers, registers()));
}

} // namespace
} // namespace symreal::trace::x86_64
#endif
