#include "program/build/make_rule.h"

#include <gtest/gtest.h>

using symreal::program::make_rule;
using symreal::program::Phony;
using symreal::program::read_make_rule;

TEST(MakeRule, NamesReadBack) {
  std::vector<std::string> const names = {"a.c",    "b c.h",   "d$e.h",     "f#g.h",
                                          "h\\i.h", "j\\ k.h", "l\\\\ m.h", "n\\#o.h"};
  EXPECT_EQ(read_make_rule(make_rule({"target.o"}, names)), names);
  for (Phony const phony : {Phony::all_but_first, Phony::all})
    EXPECT_EQ(read_make_rule(make_rule({"target.o"}, names, phony)), names);
}

TEST(MakeRule, LinesMayBeBroken) {
  EXPECT_EQ(read_make_rule("x.o: a.c \\\n b.h\nb.h:\n"), (std::vector<std::string>{"a.c", "b.h"}));
  EXPECT_TRUE(read_make_rule("x.o: \n").empty());
  EXPECT_TRUE(read_make_rule("").empty());
}
