// What tests of the trap share. Each body runs in a process of its own, since a leak is remembered.
#pragma once

#include "runtime/trace/leaks/trap.h"
#include "runtime/trace/nodes/pool.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>

namespace symreal::trace {

// Two nodes in a recording.
class TrapDeathTest : public testing::Test {
protected:
  void SetUp() override {
    trace::session().pool.begin();
    x = std::bit_cast<double>(trace::session().pool.leaf(Node::input(0), 0.5).to_bits());
    y = std::bit_cast<double>(trace::session().pool.leaf(Node::input(1), -2.0).to_bits());
  }
  void TearDown() override { trace::session().pool.end(); }

  double x, y; // nodes, as code that knows nothing of them sees them
};

inline void require(bool condition, char const *text) {
  if (condition) return;
  std::fprintf(stderr, "not so: %s\n", text);
  std::_Exit(2);
}
#define REQUIRE(condition) require(condition, #condition)
// A body as a function: the commas in it would part a macro's arguments.
using Body = std::function<void()>;
inline void in_trap(Body const &body) {
  enable_trap();
  body();
  REQUIRE(disable_trap());
  std::fputs("done\n", stderr);
  std::_Exit(0);
}
#define EXPECT_IN_TRAP(body, output) EXPECT_EXIT(in_trap(body), testing::ExitedWithCode(0), output)

inline bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

// One instruction on two doubles; `operand` stays what it was.
#define BINARY(instruction, a, operand)                                                                                \
  [](double result, double source) {                                                                                   \
    double const before = source;                                                                                      \
    asm volatile(instruction " %1, %0" : "+x"(result), "+x"(source));                                                  \
    REQUIRE(same(before, source));                                                                                     \
    return result;                                                                                                     \
  }(a, operand)

} // namespace symreal::trace
