// The trap among the program's own signal handlers, exceptions and threads.
#ifdef __x86_64__
#include "trap_fixture.h"

#include <cfenv>
#include <csignal>
#include <thread>

namespace symreal::trace {
namespace {

// The same fixture under a name of its own.
using TrapEnvironmentDeathTest = TrapDeathTest;

TEST_F(TrapEnvironmentDeathTest, LeavesTheEnvironmentAsItWas) {
  Body const body = [] {
    std::feclearexcept(FE_ALL_EXCEPT);
    static int count = 0;
    std::signal(SIGFPE, [](int) { std::_Exit(count == 2 ? 0 : 3); });
    std::signal(SIGTRAP, [](int) { ++count; });
    std::raise(SIGTRAP);
    enable_trap();
    std::raise(SIGTRAP); // passed on
    REQUIRE(disable_trap());
    double volatile zero = 0.0;
    double volatile quotient = zero / zero;
    REQUIRE(std::isnan(quotient));
    enable_trap();
    int dividend = 7;
    asm volatile("cltd\n\tidivl %1" : "+a"(dividend) : "r"(0) : "edx", "cc"); // passed on
  };
  EXPECT_EXIT(body(), testing::ExitedWithCode(0), "");
}

TEST_F(TrapEnvironmentDeathTest, IsKeptFromBeingSwitchedOff) {
  Body const body = [] {
    enable_trap();
    std::fesetenv(FE_DFL_ENV);
    REQUIRE(!disable_trap());
    enable_trap();
    std::signal(SIGFPE, SIG_DFL);
    REQUIRE(!disable_trap());
    std::_Exit(0);
  };
  EXPECT_EXIT(body(), testing::ExitedWithCode(0), "");
}

// A thread that the recording one starts inherits the exception.
TEST_F(TrapEnvironmentDeathTest, OtherThreads) {
  Body const body = [] {
    std::thread([] {
      double const volatile zero = 0.0;
      double const volatile quotient = zero / zero;
      REQUIRE(std::isnan(quotient));
    }).join();
  };
  EXPECT_IN_TRAP(body, "^done");
}

TEST_F(TrapEnvironmentDeathTest, AProgramThatWantsSignalsGetsThem) {
  Body const body = [this] {
    feenableexcept(FE_INVALID);
    enable_trap();
    REQUIRE(BINARY("addsd", x, 1.0) == 1.5);
    double volatile zero = 0.0;
    zero = zero / zero;
  };
  EXPECT_EXIT(body(), testing::KilledBySignal(SIGFPE), "computes with input 0");
}

} // namespace
} // namespace symreal::trace
#endif
