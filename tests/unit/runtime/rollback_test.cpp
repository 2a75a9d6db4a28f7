#include "runtime/memory/rollback.h"

#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

using symreal::memory::Rollback;

namespace {

struct Seen {
  int turns = 0, changed = 0;
};

int volatile counter = 7;

// Runs in a fork, which leaves more of everything in each turn.
void run(Rollback &rollback, Seen &seen) {
  int volatile local = 3;
  auto *volatile block = new int(5);
  errno = 0;
  rollback.keep();
  sigset_t blocked;
  sigprocmask(SIG_BLOCK, nullptr, &blocked);
  seen.changed += counter != 7 || local != 3 || *block != 5 || errno != 0 || std::fegetround() != FE_TONEAREST ||
                  sigismember(&blocked, SIGUSR1) != 0;
  if (++seen.turns == 5) _exit(0);
  counter = counter + 1;
  local = local + 1;
  ++*block;
  delete block;
  for (int k = 0; k < 5000; ++k) std::memset(std::malloc(100), 1, 100); // moves the end of the heap
  errno = ERANGE;
  std::fesetround(FE_UPWARD);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGUSR1);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  rollback.go_back();
  _exit(1);
}

// Leaves more of the stack than there was.
[[gnu::noinline]] void grow(int depth) {
  char volatile room[4096] = {};
  if (depth > 0) grow(depth - 1);
  room[0] = 1;
}

template <class Run> int status_of(Run run) {
  pid_t const child = fork();
  if (child == 0) run();
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

TEST(Rollback, RestoresAllMemory) {
  Rollback rollback(std::size_t{1} << 30);
  if (!rollback.is_possible()) GTEST_SKIP() << "not on this system";
  void *memory = mmap(nullptr, sizeof(Seen), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  auto *const seen = new (memory) Seen;
  EXPECT_EQ(status_of([&] { run(rollback, *seen); }), 0);
  EXPECT_EQ(seen->turns, 5);
  EXPECT_EQ(seen->changed, 0);
}

TEST(Rollback, DoesNotReturnWhereTheStackHasGrown) {
  Rollback rollback(std::size_t{1} << 30);
  if (!rollback.is_possible()) GTEST_SKIP() << "not on this system";
  int const status = status_of([&] {
    rollback.keep();
    grow(200);
    rollback.go_back();
    _exit(3);
  });
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 3);
}

} // namespace
