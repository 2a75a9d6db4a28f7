#include "program/build/workspace.h"
#include "program/record/events.h"
#include "runtime/wire/event.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace symreal;

TEST(Events, AreReadLineByLine) {
  program::Workspace const workspace(false);
  std::string const path = workspace.file("events");
  std::ofstream(path) << "started\ta.cpp:3:1\n"
                         "kernel\tarm\t0.graph\tarm.c\n"
                         "diagnostic\tSYM002\ta.cpp\t4\t5\ttext with blanks\n"
                         "decision\t7\tx > 1\t10,ff\n"
                         "located\tSYM001\tmessage\t1a\n"
                         "of another version\tignored\n";
  program::Events events = program::read_events(path);
  ASSERT_EQ(events.kernels.size(), 1u);
  EXPECT_EQ(events.kernels[0].graph_file, "0.graph");
  EXPECT_EQ(events.kernels[0].begun_as, "a.cpp:3:1");
  ASSERT_EQ(events.diagnostics.size(), 1u);
  EXPECT_EQ(events.diagnostics[0].place.column, 5u);
  EXPECT_EQ(events.diagnostics[0].message, "text with blanks");
  ASSERT_EQ(events.decisions.size(), 1u);
  EXPECT_EQ(events.decisions[0].addresses, (std::vector<std::uint64_t>{0x10, 0xff}));
  ASSERT_EQ(events.located.size(), 1u);
  EXPECT_EQ(events.located[0].addresses, std::vector<std::uint64_t>{0x1a});
}

TEST(Events, AreReadAsTheyWereWritten) {
  std::string const line = wire::line_of(wire::events::Met{"SYM001", "a\tb\nc", {0x10, 0xff}, 7});
  EXPECT_EQ(line, "met\tSYM001\ta b c\t10,ff\t7");
  program::Workspace const workspace(false);
  std::string const path = workspace.file("events");
  std::ofstream(path) << line << "\n" << wire::line_of(wire::events::Cut()) << "\nmet\tSYM001\ttoo short\n";
  program::Events const events = program::read_events(path);
  EXPECT_TRUE(events.is_cut_off);
  ASSERT_EQ(events.located.size(), 1u);
  EXPECT_EQ(events.located[0].message, "a b c");
  EXPECT_EQ(events.located[0].addresses, (std::vector<std::uint64_t>{0x10, 0xff}));
  EXPECT_EQ(events.located[0].count, 7u);
}

TEST(Events, AMissingFileHoldsNone) { EXPECT_TRUE(program::read_events("/no/such/file").kernels.empty()); }
