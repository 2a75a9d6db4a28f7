#include "program/build/process.h"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

using namespace symreal::program;

TEST(Process, GathersBothStreamsAndTheStatus) {
  Captured got = capture({.arguments = {"sh", "-c", "echo out; echo err >&2; printf last; exit 3"}});
  EXPECT_EQ(got.output, "out\nerr\nlast\n");
  EXPECT_EQ(got.outcome.ending, Ending::exited);
  EXPECT_EQ(got.outcome.status, 3);
}

TEST(Process, GivesDirectoryEnvironmentAndInput) {
  Captured got = capture({.arguments = {"sh", "-c", "pwd; echo $SYMREAL_TEST $HOME; cat"},
                          .directory = "/",
                          .environment = {"SYMREAL_TEST=a b", "HOME=/nowhere"}});
  EXPECT_EQ(got.output, "/\na b /nowhere\n");
  got = capture({.arguments = {"cat"}, .standard_input = "/proc/self/comm"});
  EXPECT_FALSE(got.output.empty());
}

TEST(Process, EndsAtTheTimeLimitWithItsChildren) {
  Captured got = capture({.arguments = {"sh", "-c", "echo begun; sleep 60 & sleep 60"}, .time_limit = 0.3});
  EXPECT_EQ(got.outcome.ending, Ending::timed_out);
  EXPECT_EQ(got.output, "begun\n");
  EXPECT_LT(got.outcome.seconds, 10);
}

char const endless[] = "exec 2>&-; while :; do :; done";

TEST(Process, EndsAsTheCallerWishes) {
  std::array<int, 2> wish;
  ASSERT_EQ(pipe2(wish.data(), O_CLOEXEC), 0);
  std::size_t lines = 0;
  Command const quiet{.arguments = {"sh", "-c", "echo begun; exec >&- 2>&-; sleep 60 & sleep 60"}, .stop = wish[0]};
  Outcome const got = run(quiet, [&](std::string_view) { ++lines, close(wish[1]); });
  EXPECT_EQ(lines, 1u);
  EXPECT_EQ(got.ending, Ending::stopped);
  EXPECT_EQ(run({.arguments = {"sleep", "60"}, .stop = wish[0]}, [](std::string_view) {}).ending, Ending::stopped);
  EXPECT_LT(got.seconds, 10);
  close(wish[0]);
}

TEST(Process, EndsAtTheLimitOfTheProcessorTimeOfItsChildrenToo) {
  Captured got = capture({.arguments = {"sh", "-c", endless}, .processor_limit = {.seconds = 0.2}});
  EXPECT_EQ(got.outcome.ending, Ending::over_limit);
  EXPECT_GE(got.outcome.processor_seconds, 0.2);
  EXPECT_GT(got.outcome.most_memory, 0u);
  std::string const in_child = std::string("(") + endless + ") & wait";
  got = capture({.arguments = {"sh", "-c", in_child}, .processor_limit = {.seconds = 0.2}});
  EXPECT_EQ(got.outcome.ending, Ending::over_limit);
}

TEST(Process, WaitsWhileItAsksForAFurtherLimit) {
  int asked = 0;
  Captured got = capture({.arguments = {"sh", "-c", endless}, .processor_limit = {0.1, [&] { return ++asked, 0.3; }}});
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(got.outcome.ending, Ending::over_limit);
  EXPECT_GE(got.outcome.processor_seconds, 0.3);
  got = capture({.arguments = {"sh", "-c", "while [ $((k += 1)) -lt 300000 ]; do :; done; echo done"},
                 .processor_limit = {0.05, [&] { return ++asked, 1e9; }}});
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(got.output, "done\n");
  EXPECT_TRUE(got.outcome.success());
}

TEST(Process, TellsSignalsFromStatus) {
  Captured got = capture({.arguments = {"sh", "-c", "kill -SEGV $$"}});
  EXPECT_EQ(got.outcome.ending, Ending::signalled);
  EXPECT_EQ(got.outcome.status, SIGSEGV);
}

TEST(Process, SaysWhyItDidNotStart) {
  Captured got = capture({.arguments = {"symreal-no-such-program"}});
  EXPECT_EQ(got.outcome.ending, Ending::not_started);
  EXPECT_EQ(got.outcome.status, ENOENT);
}

TEST(Words, AreCutAsAShellDoes) {
  EXPECT_EQ(split_words("a 'b c' \"d \\\" e\" f\\ g ''"), (std::vector<std::string>{"a", "b c", "d \" e", "f g", ""}));
  EXPECT_EQ(shell_line({"g++", "-DX='1'", ""}), "g++ '-DX='\\''1'\\''' ''");
}
