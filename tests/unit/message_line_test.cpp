#include "program/build/compiler_messages.h"

#include <gtest/gtest.h>

namespace symreal::program {
namespace {

TEST(MessageLine, APlaceAKindAndAText) {
  std::optional<MessageLine> const line = message_line("src/a b.cpp:12:7: error: expected ';': not ':'");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->place.file, "src/a b.cpp");
  EXPECT_EQ(line->place.line, 12u);
  EXPECT_EQ(line->place.column, 7u);
  EXPECT_EQ(line->text("error"), "expected ';': not ':'");
  EXPECT_FALSE(line->text("note"));
}

TEST(MessageLine, AColumnAndAKindMayBeMissing) {
  std::optional<MessageLine> const line = message_line("a.cpp:12:   required from here");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->place.line, 12u);
  EXPECT_EQ(line->place.column, 0u);
  EXPECT_EQ(line->text(), "required from here");
  EXPECT_EQ(line->rest, ":   required from here");
  EXPECT_FALSE(line->text("error"));
}

TEST(MessageLine, AFileIsIncludedOrHasNoLine) {
  std::optional<MessageLine> const included = message_line("In file included from a.h:3:2,");
  ASSERT_TRUE(included);
  EXPECT_EQ(included->before, "In file included from ");
  EXPECT_EQ(included->place.file, "a.h");
  EXPECT_EQ(included->rest, ",");
  std::optional<MessageLine> const within = message_line("a.cpp: In function 'f':");
  ASSERT_TRUE(within);
  EXPECT_EQ(within->place.line, 0u);
  EXPECT_EQ(within->rest, ": In function 'f':");
  for (char const *other : {"", ":", "  ^~~~"}) EXPECT_FALSE(message_line(other)) << other;
}

} // namespace
} // namespace symreal::program
