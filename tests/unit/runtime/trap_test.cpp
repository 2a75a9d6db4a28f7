// The trap on instructions that are really executed, compiled or written out.
#ifdef __x86_64__
#include "trap_fixture.h"

#include <cfenv>
#include <limits>

namespace symreal::trace {
namespace {

TEST_F(TrapDeathTest, ArithmeticGoesOnWithTheCarriedValues) {
  Body const body = [this] {
    REQUIRE(BINARY("addsd", x, y) == -1.5);
    REQUIRE(BINARY("mulsd", 4.0, x) == 2.0);
    REQUIRE(BINARY("divsd", x, 2.0) == 0.25);
    REQUIRE(BINARY("sqrtsd", 7.0, x) == std::sqrt(0.5));
    REQUIRE(BINARY("minsd", 1.0, x) == 0.5);
    REQUIRE(BINARY("maxsd", x, 0.0) == 0.5);
    REQUIRE(BINARY("mulsd", x, std::bit_cast<double>(std::bit_cast<std::uint64_t>(y) & ~0ull >> 1)) == 1.0);
  };
  EXPECT_IN_TRAP(body, "done");
}

TEST_F(TrapDeathTest, LeaksAreReportedOnceAPlace) {
  Body const body = [this] {
    for (int volatile times = 3; times > 0; times = times - 1) // one place: no compiler unrolls it
      REQUIRE(BINARY("maxsd", 1.0, y) == 1.0);
  };
  EXPECT_IN_TRAP(body, "^[^\n]*computes with input 1 [^\n]*\n[^\n]*help: [^\n]*\ndone");
}

TEST_F(TrapDeathTest, ComparisonsAndConversions) {
  Body const body = [this] {
    bool below = false;
    asm volatile("ucomisd %2, %1\n\tseta %0" : "=q"(below) : "x"(x), "x"(y) : "cc");
    REQUIRE(below);
    asm volatile("comisd %2, %1\n\tseta %0" : "=q"(below) : "x"(y), "m"(x) : "cc");
    REQUIRE(!below);
    long integer = 0;
    asm volatile("cvttsd2si %1, %0" : "=r"(integer) : "x"(y));
    REQUIRE(integer == -2);
    float single = 0;
    asm volatile("cvtsd2ss %1, %0" : "=x"(single) : "m"(x));
    REQUIRE(single == 0.5f);
  };
  EXPECT_IN_TRAP(body, "done");
}

TEST_F(TrapDeathTest, OperandsInMemoryStay) {
  Body const body = [this] {
    double memory[2] = {x, 3.0};
    double const before[2] = {1.0, 2.0};
    typedef double Pair __attribute__((vector_size(16)));
    Pair pair = {before[0], before[1]};
    alignas(16) double aligned[2] = {memory[0], memory[1]};
    asm volatile("addpd %1, %0" : "+x"(pair) : "m"(aligned));
    REQUIRE(pair[0] == 1.5 && pair[1] == 5.0 && same(aligned[0], x));
    static thread_local double local;
    local = x;
    double const volatile sum = local + 1.0;
    REQUIRE(sum == 1.5 && same(local, x));
  };
  EXPECT_IN_TRAP(body, "done");
}

TEST_F(TrapDeathTest, WideRegisters) {
  if (!__builtin_cpu_supports("avx")) GTEST_SKIP() << "no AVX";
  Body const body = [this] {
    double const numbers[4] = {1, 2, 3, x};
    double result[4];
    double kept[4];
    asm volatile("vmovupd %2, %%ymm9\n\tvaddpd %%ymm9, %%ymm9, %%ymm2\n\tvmovupd %%ymm2, %0\n\tvmovupd %%ymm9, %1"
                 : "=m"(result), "=m"(kept)
                 : "m"(numbers)
                 : "xmm2", "xmm9");
    REQUIRE(result[0] == 2 && result[2] == 6 && result[3] == 1.0 && same(kept[3], x));
  };
  EXPECT_IN_TRAP(body, "done");
}

TEST_F(TrapDeathTest, WidestRegisters) {
  if (!__builtin_cpu_supports("avx512f")) GTEST_SKIP() << "no AVX-512";
  Body const body = [this] {
    double const numbers[8] = {1, 2, 3, 4, 5, x, 7, y};
    double result[8];
    double kept[8];
    asm volatile("vmovupd %2, %%zmm25\n\tvmulpd %%zmm25, %%zmm25, %%zmm3\n\t"
                 "vmovupd %%zmm3, %0\n\tvmovupd %%zmm25, %1\n\tvmovupd %2, %%zmm4\n\tvaddpd %%zmm4, %%zmm3, %%zmm4\n\t"
                 "vmovupd %%zmm4, %0"
                 : "=m"(result), "=m"(kept)
                 : "m"(numbers)
                 : "xmm3", "xmm4");
    REQUIRE(result[4] == 30 && result[5] == 0.75 && result[7] == 2.0 && same(kept[5], x));
  };
  EXPECT_IN_TRAP(body, "done");
}

TEST_F(TrapDeathTest, LongDouble) {
  Body const body = [this] {
    double const volatile memory = x;
    long double volatile wide = memory;
    REQUIRE(wide == 0.5L);
    wide = wide + static_cast<long double>(memory);
    REQUIRE(wide == 1.0L);
    long double sum = 2.0L;
    asm volatile("faddl %1" : "+t"(sum) : "m"(memory));
    REQUIRE(sum == 2.5L);
  };
  EXPECT_IN_TRAP(body, "computes with input 0");
}

// Nothing is reported, and the results are what they are without the trap.
TEST_F(TrapDeathTest, TheProgramsOwnInvalidOperations) {
  Body const body = [this] {
    double const volatile zero = 0.0, minus = -1.0, huge = 1e300;
    double const volatile quotient = zero / zero, root = BINARY("sqrtsd", 0.0, minus);
    REQUIRE(std::isnan(quotient) && std::signbit(quotient) && std::isnan(root));
    // The bits in a destination that is only written are no operand.
    REQUIRE(std::isnan(BINARY("sqrtsd", x, minus)));
    REQUIRE(static_cast<int>(huge) == std::numeric_limits<int>::min());
    REQUIRE(!(quotient < zero));
    long double const volatile wide = 0.0L;
    long double const volatile wide_quotient = wide / wide;
    REQUIRE(std::isnan(wide_quotient) && !(wide_quotient < wide));
    REQUIRE(std::isnan(std::log(minus)) && std::isnan(std::acos(huge)));
    REQUIRE(std::fetestexcept(FE_INVALID) != 0);
  };
  EXPECT_IN_TRAP(body, "^done");
}

TEST_F(TrapDeathTest, StaleNodes) {
  trace::session().pool.end();
  trace::session().pool.begin();
  Body const body = [this] { REQUIRE(std::isnan(BINARY("addsd", x, 1.0))); };
  EXPECT_IN_TRAP(body, "another kernel or thread");
}

} // namespace
} // namespace symreal::trace
#endif
