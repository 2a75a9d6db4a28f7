#include "program/build/directives.h"

#include <gtest/gtest.h>

using symreal::program::read_directives;

namespace {

std::string words(std::string const &text) {
  std::string result;
  for (auto const &word : read_directives(text).identifiers) result += word.text + " ";
  return result;
}

TEST(Directives, WordsAreThoseOfTheCode) {
  EXPECT_EQ(words("int a; /* b\n c */ d = 'e' + \"f \\\" g\"; // h \\\n i\nj"), "int a d j ");
  EXPECT_EQ(words("1.5e3 0x1p3 x1 2u"), "x1 ");
  EXPECT_EQ(words("# error don't\nx"), "don x "); // an apostrophe alone ends with its line
  EXPECT_EQ(words("#include <linux/a.h>\n#include \"unix.h\"\n#include NAME\nlinux < unix > y"), "NAME linux unix y ");
}

TEST(Directives, EachHasItsLinesAndWords) {
  std::string const text = "x\n  # if A \\\n  && B /* C */\n#endif\ny # if\n/* \n#if D\n*/ #ifdef E\n";
  auto const found = read_directives(text).directives;
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].keyword, "if");
  EXPECT_EQ(text.substr(found[0].begin, 4), "# if");
  ASSERT_EQ(found[0].identifiers.size(), 2u);
  EXPECT_EQ(found[0].identifiers[1].text, "B");
  EXPECT_EQ(found[1].keyword, "endif");
  EXPECT_EQ(found[2].keyword, "ifdef");
  EXPECT_EQ(text.substr(found[2].begin, 6), "#ifdef"); // behind a comment
}

} // namespace
