#include "rewrite/text/compose.h"

#include <gtest/gtest.h>

using namespace symreal::rewrite;

namespace {

std::string composed(std::string const &text, std::vector<Rewording> rewordings) {
  std::vector<Edit> const edits = compose(text, std::move(rewordings));
  for (Edit const &edit : edits) EXPECT_GT(edit.length, 0u);
  return apply_edits(text, edits);
}

} // namespace

TEST(Compose, WrapsNestByLengthAndOnTheSameCharactersByDepth) {
  EXPECT_EQ(composed("f(a + b)", {{2, 7, "<", ">"}, {2, 3, "[", "]"}, {6, 7, "{", "}"}}), "f(<[a] + {b}>)");
  EXPECT_EQ(composed("x", {{0, 1, "in(", ")", false, 2}, {0, 1, "out(", ")", false, 1}}), "out(in(x))");
}

TEST(Compose, AReplacementKeepsTheWrapsThatBeginOrEndOnIt) {
  EXPECT_EQ(composed("(double)x", {{1, 7, "REAL", "", true}, {0, 9, "TO(", ")"}}), "TO((REAL)x)");
  EXPECT_EQ(composed("double", {{0, 6, "REAL", "", true}, {0, 6, "(", ")"}}), "(REAL)");
}

TEST(Compose, EditsAreSortedAndDoNotOverlap) {
  std::vector<Edit> const edits = compose("a b c", {{4, 5, "<", ">"}, {0, 5, "(", ")"}});
  ASSERT_EQ(edits.size(), 2u);
  EXPECT_LE(edits[0].offset + edits[0].length, edits[1].offset);
}

TEST(Compose, NewTextMakesNoWordWithItsNeighbours) {
  EXPECT_EQ(composed("{y=1;", {{0, 1, "", " BEGIN END"}, {1, 2, "WRITTEN(", ")"}}), "{ BEGIN END WRITTEN(y)=1;");
  EXPECT_EQ(composed("{y=1;", {{0, 1, "", " BEGIN END"}}), "{ BEGIN END y=1;");
  EXPECT_EQ(composed("return(x)", {{6, 9, "READ(", ")"}}), "return READ((x))");
  EXPECT_EQ(composed("x;", {{0, 1, "READ(", ")"}}), "READ(x);");
}
