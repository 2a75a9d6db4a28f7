// The bytes that code reads and writes, by the addresses that it meets.
#include "runtime/memory/access_watch.h"

#include <cstring>
#include <gtest/gtest.h>

namespace symreal::memory {
namespace {

// Pages of its own, so that the test's own variables are not watched.
struct alignas(4096) Watched {
  int mode = 3;
  int copy = 0;
  long counter = 0;
  char text[64] = "slow";
  double table[256] = {};
};
Watched watched;

Access const *find(std::vector<Access> const &all, void const *address) {
  for (Access const &one : all)
    if (one.address == address) return &one;
  return nullptr;
}

std::vector<Access> accesses_of(void (*function)()) {
  if (!begin_watching_accesses({{reinterpret_cast<char *>(&watched), sizeof watched}})) return {};
  function();
  return end_watching_accesses().all;
}

class AccessWatch : public testing::Test {
protected:
  void SetUp() override {
    if (!begin_watching_accesses({{reinterpret_cast<char *>(&watched), sizeof watched}}))
      GTEST_SKIP() << "not on this machine";
    (void)end_watching_accesses();
  }
};

TEST_F(AccessWatch, TellsReadsFromWrites) {
  auto const all = accesses_of([] { *static_cast<int volatile *>(&watched.copy) = watched.mode; });
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(find(all, &watched.mode)->is_read_first);
  EXPECT_FALSE(find(all, &watched.mode)->is_written);
  EXPECT_FALSE(find(all, &watched.copy)->is_read_first);
  EXPECT_TRUE(find(all, &watched.copy)->is_written);
}

TEST_F(AccessWatch, KnowsWhatIsReadBehindItsWrite) {
  auto const all = accesses_of([] {
    *static_cast<long volatile *>(&watched.counter) = 1;
    *static_cast<long volatile *>(&watched.counter) = *static_cast<long volatile *>(&watched.counter) * 2;
  });
  ASSERT_EQ(all.size(), 1u);
  EXPECT_FALSE(all[0].is_read_first);
}

TEST_F(AccessWatch, SeesWhatNoCompilerTells) {
  auto const all = accesses_of([] {
    memccpy(watched.text, "fast", 0, 5);
#ifdef __x86_64__
    int mode = 0;
    asm volatile("movl %1, %0" : "=r"(mode) : "m"(watched.mode));
#endif
  });
  EXPECT_TRUE(find(all, watched.text)->is_written);
  EXPECT_TRUE(find(all, &watched.mode)->is_read_first);
}

TEST_F(AccessWatch, LeavesValuesAlone) {
  auto const all = accesses_of([] {
    for (double volatile &one : watched.table) one = one + 1;
  });
  EXPECT_EQ(all.size(), 256u);
  EXPECT_EQ(watched.table[0], 1);
  EXPECT_EQ(watched.table[255], 1);
}

} // namespace
} // namespace symreal::memory
