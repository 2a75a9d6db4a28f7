#include "program/process.h"

#include <gtest/gtest.h>

#include <csignal>

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
