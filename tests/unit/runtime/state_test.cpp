#include "runtime/trace/state/state.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <memory>

using namespace symreal;
using trace::Shadow;
namespace mark = trace::mark;

// Links the allocation functions that a recording is told by; a sanitizer brings its own.
#ifndef __SANITIZE_ADDRESS__
extern "C" char symreal_heap_hooks;
static bool const heap_is_known = symreal_heap_hooks == 0;
#else
static bool const heap_is_known = false;
#endif

namespace {

// A recording without a graph: plain numbers only.
class Kernel {
public:
  Kernel() { trace::session().state.begin(__builtin_frame_address(0)); }
  ~Kernel() {
    if (detail::recording) (void)trace::session().state.end();
  }
  std::map<std::string, std::vector<double>> frozen() {
    std::map<std::string, std::vector<double>> values;
    for (Frozen const &one : trace::session().state.end()) values[one.name] = one.values;
    return values;
  }
};

using Values = std::map<std::string, std::vector<double>>;

RealNumber &read(RealNumber &number, char const *name) { return symreal::symreal_read(number, name, "a.cpp:1:1"); }

struct Members {
  RealNumber first = 1.0;
  int count = 2;
  RealNumber rest[2] = {3.0, 4.0};
  void symreal_members(Numbers &numbers) const { numbers.visit(first, rest); }
};

} // namespace

class HeapState : public testing::Test {
protected:
  void SetUp() override {
    if (!heap_is_known) GTEST_SKIP() << "the sanitizer brings an allocator of its own";
  }
};

TEST(Shadow, MarksWordsOfMemory) {
  Shadow shadow;
  alignas(8) char memory[64] = {};
  shadow.set(memory + 8, 16, mark::own);
  EXPECT_EQ(shadow.at(memory), 0);
  EXPECT_EQ(shadow.at(memory + 8), mark::own);
  EXPECT_EQ(shadow.at(memory + 23), mark::own);
  EXPECT_EQ(shadow.at(memory + 24), 0);
  shadow.add(memory + 16, 16, mark::noted);
  EXPECT_EQ(shadow.at(memory + 16), mark::own | mark::noted);
  EXPECT_EQ(shadow.at(memory + 24), mark::noted);
}

TEST(Shadow, MarksMoveWithMemory) {
  Shadow shadow;
  std::vector<double> from(1000), to(1000);
  shadow.set(&from[600], 8, mark::noted);
  shadow.paste(to.data(), shadow.copy(from.data(), 8000));
  EXPECT_EQ(shadow.at(&to[600]), mark::noted);
  EXPECT_EQ(shadow.at(&to[601]), 0);
}

TEST_F(HeapState, BlocksOfTheKernelAreItsOwn) {
  auto older = std::make_unique<RealNumber>(2.0);
  Kernel kernel;
  auto own = std::make_unique<RealNumber>(3.0);
  read(*older, "older");
  read(*own, "own");
  EXPECT_EQ(kernel.frozen(), (Values{{"older", {2.0}}}));
}

TEST_F(HeapState, ABlockThatGrowsKeepsItsOldNumbers) {
  auto *block = static_cast<RealNumber *>(std::malloc(sizeof(RealNumber)));
  *block = 2.0;
  Kernel kernel;
  block = static_cast<RealNumber *>(std::realloc(block, 1000 * sizeof(RealNumber)));
  block[999] = 3.0;
  read(block[0], "block");
  read(block[999], "block");
  EXPECT_EQ(kernel.frozen(), (Values{{"block", {2.0}}}));
  std::free(block);
}

TEST_F(HeapState, FreedMemoryIsForgotten) {
  auto *block = static_cast<RealNumber *>(std::malloc(sizeof(RealNumber)));
  *block = 2.0;
  Kernel kernel;
  std::free(block);
  auto *again = static_cast<RealNumber *>(std::malloc(sizeof(RealNumber)));
  *again = 3.0;
  read(*again, "block");
  EXPECT_TRUE(kernel.frozen().empty());
  std::free(again);
}

TEST_F(HeapState, WhatIsWrittenFirstIsNotFrozen) {
  static RealNumber numbers[2] = {1.0, 2.0};
  Kernel kernel;
  symreal_written(numbers[0], "numbers[0]", "a.cpp:1:1") = 3.0;
  read(numbers[0], "numbers[i]");
  read(numbers[1], "numbers[i]");
  EXPECT_EQ(kernel.frozen(), (Values{{"numbers[i]", {2.0}}}));
}

TEST(State, StaticObjectsHaveTheirName) {
  static RealNumber numbers[3] = {1.0, 2.0, 3.0};
  Kernel kernel;
  RealNumber *p = symreal_state(numbers, "numbers", "a.cpp:1:1");
  read(p[2], "p[2]");
  read(p[0], "*p");
  EXPECT_EQ(kernel.frozen(), (Values{{"numbers", {3.0, 1.0}}}));
}

TEST(State, ConstantMemoryAndTheOwnStackAreNotAsked) {
  static RealNumber const fixed[1] = {1.0};
  Kernel kernel;
  [&] {
    RealNumber local = 2.0;
    read(local, "local");
    symreal::symreal_read(fixed[0], "fixed", "a.cpp:1:1");
  }();
  EXPECT_TRUE(kernel.frozen().empty());
}

TEST_F(HeapState, WholeObjectsTellTheirNumbers) {
  auto older = std::make_unique<Members>();
  auto pair = std::make_unique<std::pair<int, std::vector<Members>>>(1, std::vector<Members>(1));
  Kernel kernel;
  symreal::symreal_read(*older, "older", "a.cpp:1:1");
  declare_object<Kind::constant>(*pair);
  symreal::symreal_read(pair->second[0], "element", "a.cpp:1:1");
  EXPECT_EQ(kernel.frozen(), (Values{{"older", {1.0, 3.0, 4.0}}}));
}

TEST_F(HeapState, IntegersShareWords) {
  auto older = std::make_unique<short[]>(4);
  for (int i = 0; i < 4; i++) older[i] = static_cast<short>(-1 - i);
  Kernel kernel;
  declare_object<Kind::constant>(older[1]);
  for (int i = 0; i < 3; i++) symreal::symreal_read(older[i], "older[i]", "a.cpp:1:1");
  symreal_written(older[3], "older[3]", "a.cpp:1:1") = 1;
  symreal::symreal_read(older[3], "older[3]", "a.cpp:2:1");
  detail::scratch(&older[3], sizeof older[3], detail::visit<short>);
  EXPECT_EQ(kernel.frozen(), (Values{{"older[i]", {-1.0, -3.0}}}));
}

TEST_F(HeapState, IntegersMoveWithTheirBlock) {
  auto *block = static_cast<int *>(std::malloc(2 * sizeof(int)));
  block[0] = 2, block[1] = 3;
  Kernel kernel;
  symreal::symreal_read(block[0], "block", "a.cpp:1:1");
  block = static_cast<int *>(std::realloc(block, 1000 * sizeof(int)));
  symreal::symreal_read(block[0], "block", "a.cpp:1:1");
  symreal::symreal_read(block[1], "block", "a.cpp:1:1");
  block[999] = 4;
  symreal::symreal_read(block[999], "block", "a.cpp:1:1");
  EXPECT_EQ(kernel.frozen(), (Values{{"block", {2.0, 3.0}}}));
  std::free(block);
}

TEST_F(HeapState, RangesAreNotedByTheirSecondEnd) {
  auto older = std::make_unique<RealNumber[]>(4);
  for (int i = 0; i < 4; i++) older[i] = i;
  Kernel kernel;
  symreal_range_end(&older[3], "older", "a.cpp:1:1");
  symreal_range_begin(&older[1], "older", "a.cpp:1:1");
  EXPECT_EQ(kernel.frozen(), (Values{{"older", {1.0, 2.0}}}));
}
